# What `cmake --install` puts where, and the packages that CPack makes of it:
# the program, what other programs need of it, and the module of Python.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(_packaging ${CMAKE_CURRENT_LIST_DIR})
set(_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/Voussoir)

set(VOUSSOIR_MAINTAINER "The Voussoir developers <voussoir@localhost>" CACHE
  STRING "Who makes the packages, NAME <ADDRESS>")

# Debian wants manual pages and the list of changes compressed.
foreach(_file voussoir.1 changelog)
  configure_file(${_packaging}/${_file} ${CMAKE_BINARY_DIR}/${_file} @ONLY)
  execute_process(COMMAND gzip -9 -n -c ${CMAKE_BINARY_DIR}/${_file}
    OUTPUT_FILE ${CMAKE_BINARY_DIR}/${_file}.gz)
endforeach()

# The program, with scenes and manual.
install(TARGETS voussoir COMPONENT program
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Scenes of models read files of tests, which are not installed.
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir
  COMPONENT program PATTERN prm/space/models EXCLUDE)
# What --check runs, found by the program beside where it is.
install(PROGRAMS contrib/check_proof DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir
  COMPONENT program)
install(DIRECTORY contrib/proof DESTINATION ${CMAKE_INSTALL_DATADIR}/voussoir
  COMPONENT program FILES_MATCHING PATTERN "*.py")
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/voussoir)
foreach(_file check_proof proof)
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/contrib/${_file}
    ${CMAKE_BINARY_DIR}/share/voussoir/${_file} SYMBOLIC)
endforeach()
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/doc
  COMPONENT program PATTERN doxygen EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/voussoir.1.gz
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
add_custom_command(TARGET voussoir POST_BUILD
  COMMAND voussoir --print-completion >${CMAKE_BINARY_DIR}/voussoir.bash)
install(FILES ${CMAKE_BINARY_DIR}/voussoir.bash RENAME voussoir
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT program)

# The library.
install(TARGETS libvoussoir EXPORT VoussoirTargets COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/voussoir ${CMAKE_BINARY_DIR}/include/voussoir
  DESTINATION include COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN python EXCLUDE
  PATTERN precompiled.h EXCLUDE PATTERN gdal_library.h EXCLUDE)
install(EXPORT VoussoirTargets NAMESPACE Voussoir:: DESTINATION ${_cmake}
  COMPONENT development)
configure_package_config_file(${_packaging}/VoussoirConfig.cmake.in
  ${CMAKE_BINARY_DIR}/VoussoirConfig.cmake INSTALL_DESTINATION ${_cmake})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/VoussoirConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/VoussoirConfig.cmake
  ${CMAKE_BINARY_DIR}/VoussoirConfigVersion.cmake
  DESTINATION ${_cmake} COMPONENT development)

if(VOUSSOIR_PYTHON)
  set(VOUSSOIR_PYTHON_DIRECTORY lib/python3/dist-packages CACHE STRING
    "Where the module of Python is installed, below the prefix")
  install(TARGETS python_module COMPONENT python
    LIBRARY DESTINATION ${VOUSSOIR_PYTHON_DIRECTORY}/voussoir)
  install(DIRECTORY source/python/voussoir COMPONENT python
    DESTINATION ${VOUSSOIR_PYTHON_DIRECTORY} FILES_MATCHING PATTERN "*.py")
endif()

# The packages of Debian, one for each component.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME voussoir)
set(CPACK_PACKAGE_VENDOR "The Voussoir developers")
set(CPACK_PACKAGE_CONTACT ${VOUSSOIR_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development)
set(_names voussoir libvoussoir-dev)
if(VOUSSOIR_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  list(APPEND _names python3-voussoir)
endif()

set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "contact forces and stresses in packings of rigid blocks
Voussoir computes the contact forces between, and the stresses inside, the
rigid polygonal blocks of brick walls, arches, vaults and packings of grains,
with friction and without interpenetration: whether a load is carried, how
much more, and how sure that is, each with a proof.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "library of the program voussoir
The static library, its headers, and a package of CMake with the target
Voussoir::libvoussoir, for programs with formulations of their own.")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "module of Python for packings of rigid blocks
Scenes from files or arrays of polygons, and forces, stresses and mechanisms
as arrays of numpy, found by the program voussoir's library.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME voussoir)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libvoussoir-dev)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-voussoir)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${_packaging}/python/postinst ${_packaging}/python/prerm)
# Libraries that dpkg-shlibdeps does not see: the BLAS has a directory of its own
# (see doc/developers.md), and GDAL is loaded when a file asks for it.
set(_depends "")
if(VOUSSOIR_OPENBLAS AND OPENBLAS_LIBRARY)
  list(APPEND _depends libopenblas0-pthread)
endif()
if(VOUSSOIR_GDAL)
  string(REPLACE ".so." "" _package ${VOUSSOIR_GDAL_LIBRARY})
  list(APPEND _depends ${_package})
endif()
string(REPLACE ";" ", " CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${_depends}")
list(APPEND _depends python3 python3-numpy)
string(REPLACE ";" ", " CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${_depends}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "cmake, g++, coinor-libclp-dev, coinor-libipopt-dev, libboost-dev, libboost-program-options-dev, libcgal-dev, libdeal.ii-dev, liblz4-dev, libsuitesparse-dev, mpi-default-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3") # for --check
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, python3-voussoir")

foreach(_name ${_names})
  list(FIND _names ${_name} _place)
  list(GET CPACK_COMPONENTS_ALL ${_place} _component)
  install(FILES ${_packaging}/copyright DESTINATION share/doc/${_name}
    COMPONENT ${_component})
  install(FILES ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION share/doc/${_name}
    COMPONENT ${_component})
  if(NOT _name STREQUAL "libvoussoir-dev")
    install(FILES ${_packaging}/${_name}.lintian RENAME ${_name}
      DESTINATION share/lintian/overrides COMPONENT ${_component})
  endif()
endforeach()
include(CPack)
