// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_stress_reconstruction_h
#define voussoir_stress_reconstruction_h

#include <voussoir/scene/scene.h>
#include <voussoir/stress/cell_stress.h>
#include <voussoir/stress/side_forces.h>
#include <voussoir/terminal/terminal.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

namespace Voussoir
{
/** The method by which the stress inside the cells is reconstructed. */
struct Reconstruction
{
  /** True for LeastNorm, false for Fan. */
  bool is_refined = false;
  /**
   * Of LeastNorm: the number of times that its quadrilaterals are cut in four.
   */
  unsigned int n_refinements = 0;
  /** Of LeastNorm: the degree k of FE_RaviartThomas. */
  unsigned int degree = 0;

  /** The cut of each triangle: fan() or thirds(). */
  SubTriangulation cut() const
  {
    return is_refined ? SubTriangulation::thirds(n_refinements)
                      : SubTriangulation::fan();
  }

  /** The shortest side that it may have; see ShortSides. */
  double shortest_side() const;

  /** The solver of cells with @p n_sides sides: a Fan or a LeastNorm. */
  std::unique_ptr<CellStress> cell_stress(unsigned int n_sides) const;
};

/** The stress inside the cells. */
struct StressField
{
  /** The cut of each triangle of a cell's centre and one side. */
  SubTriangulation cut = SubTriangulation::fan();
  /**
   * The stress of each sub-cell, cell by cell and in these triangle by
   * triangle; see first(). Empty if no reconstruction was asked for.
   */
  std::vector<SubCellStress> sub_cells;
  /** The number of sub-cells; more than here if several processes have them. */
  unsigned long long n_sub_cells = 0;
  /**
   * The cells for which the stress is not determined, or lost to rounding;
   * their sub-cells all have the mean stress of the cell. Ascending.
   */
  std::vector<unsigned int> undetermined;

  /**
   * The index in sub_cells of the first one of the triangle of side @p i of
   * @p cell; for side 0 of cell n_cells() their number.
   */
  std::size_t first(const Packing<2> &packing,
                    const unsigned int cell,
                    const unsigned int i) const
  {
    return (packing.first_side(cell) + i) * cut.of_triangle().size();
  }
};

/**
 * A sentence for the user on the undetermined cells, or none: how many, and
 * which is the first.
 */
std::vector<std::string> undetermined_cells(const Scene &scene,
                                            const StressField &field);

/** The entry `Accuracy` and the section `Stress`. */
class StressParameters
{
public:
  /** Declare the entry and the section, and bind them. */
  void add_parameters(dealii::ParameterHandler &prm);

  /** True if the stress inside the cells is to be reconstructed at all. */
  bool reconstruct() const { return accuracy != Accuracy::draft; }
  /** The method, if it is. */
  Reconstruction reconstruction() const
  {
    return {accuracy == Accuracy::fine, n_refinements, degree};
  }

private:
  enum class Accuracy
  {
    draft,
    standard,
    fine
  };

  Accuracy accuracy = Accuracy::standard;
  unsigned int n_refinements = 0;
  unsigned int degree = 0;
};

/**
 * Find the stress in every cell under the forces on it, on all threads. The
 * result does not depend on their number.
 *
 * @param packing has the cells.
 * @param forces on all of them.
 * @param how by which elements.
 * @param terminal sees the progress.
 */
StressField reconstruct_stress(const Packing<2> &packing,
                               const CellForces &forces,
                               const Reconstruction &how,
                               Terminal &terminal);

/** The stress in all cells of a scene. */
StressField reconstruct_stress(const Scene &scene,
                               const InterfaceForces &forces,
                               const Reconstruction &how,
                               Terminal &terminal);
} // namespace Voussoir

#endif
