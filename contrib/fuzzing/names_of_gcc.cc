// SPDX-License-Identifier: LGPL-2.1-or-later

// Three functions of deal.II of which Clang makes other symbols than GCC, by
// which deal.II was compiled: templates with a trait in their types. Each
// symbol of Clang's leads to that of GCC.

#ifndef __x86_64__
#error "Write the jumps of this processor here."
#endif

#define VOUSSOIR_FUZZ_JUMP(clang, gcc)                                         \
  asm(".text\n.globl " clang "\n.type " clang ", @function\n" clang            \
      ":\n  jmp " gcc "@PLT\n")

VOUSSOIR_FUZZ_JUMP(
    "_ZN6dealii12eigenvectorsILi3EdEESt5arrayISt4pairIT0_NS_6TensorILi1EXT_ES3_"
    "EEEXsr3std17integral_constantIiXT_EEE5valueEERKNS_"
    "15SymmetricTensorILi2EXT_"
    "ES3_EENS_32SymmetricTensorEigenvectorMethodE",
    "_ZN6dealii12eigenvectorsILi3EdEESt5arrayISt4pairIT0_NS_6TensorILi1EXT_ES3_"
    "EEEXsrSt17integral_constantIiXT_EE5valueEERKNS_15SymmetricTensorILi2EXT_"
    "ES3_EENS_32SymmetricTensorEigenvectorMethodE");

VOUSSOIR_FUZZ_JUMP(
    "_ZN6dealii16TrilinosWrappers12SparseMatrix6reinitINS_"
    "22DynamicSparsityPatternEEENSt9enable_ifIXntsr3std7is_sameIT_NS_"
    "12SparseMatrixIdEEEE5valueEvE4typeERKNS_8IndexSetESC_RKS5_RKP19ompi_"
    "communicator_tb",
    "_ZN6dealii16TrilinosWrappers12SparseMatrix6reinitINS_"
    "22DynamicSparsityPatternEEENSt9enable_ifIXntsrSt7is_sameIT_NS_"
    "12SparseMatrixIdEEE5valueEvE4typeERKNS_8IndexSetESE_RKS6_RKP19ompi_"
    "communicator_tb");

VOUSSOIR_FUZZ_JUMP(
    "_ZNK6dealii16TrilinosWrappers12SparseMatrix5vmultINS0_3MPI6VectorEEENSt9"
    "enable_ifIXsr3std7is_sameINT_10value_typeEdEE5valueEvE4typeERS6_RKS6_",
    "_ZNK6dealii16TrilinosWrappers12SparseMatrix5vmultINS0_3MPI6VectorEEENSt9"
    "enable_ifIXsrSt7is_sameINT_10value_typeEdE5valueEvE4typeERS7_RKS7_");
