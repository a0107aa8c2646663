// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_certificate_measures_h
#define voussoir_scene_proofs_certificate_measures_h

#include <algorithm>
#include <vector>

namespace Voussoir
{
/** A cell whose forces do not balance by their own measure. */
struct UnbalancedCell
{
  /** Its number. */
  unsigned int cell;
  /**
   * The size of the sum of all forces on it, or of their torque over the square
   * root of its area if it turns, or what a force of one of its interfaces is
   * beyond its limit, whichever is most; S L.
   */
  double imbalance;
  /**
   * Its measure: the sum of the sizes of the loads on it, or if it has none
   * that of the largest light one beside it, or else the largest force of its
   * interfaces; S L.
   */
  double own_force;
};

/** The largest error of a set of interface forces. */
struct LargestError
{
  /** What is wrong. */
  enum class Kind
  {
    /** The sum of the forces on a cell is not zero. */
    balance,
    /** The sum of their torques is not. */
    moment,
    /** A force of an interface is beyond its limit. */
    limit
  };

  /** Of that kind. */
  Kind kind = Kind::balance;
  /** The cell; of an interface c-. */
  unsigned int cell = 0;
  /** The error as a force, a torque over the root of the area; S L. */
  double size = 0.;
  /** LargestError::size over the reference force. */
  double relative = 0.;
};

/**
 * The errors of a set of interface forces (paper, eqs. 1, 12 and 13), computed
 * from the scene and the forces alone, in the user's units, by code that no
 * solver shares. Each group of cells that touch each other has a reference
 * force of its own, the largest load on one of them; without it the largest of
 * the scene counts, or else the largest force. The measures are those of the
 * worst group.
 */
struct Certificate
{
  /** Largest size of the sum of all forces on a cell, over the reference. */
  double equilibrium_residual = 0.;
  /**
   * Largest violation of f_e^n <= 0 and of |f_e^t| <= s_e |e|, or of what else
   * JointLimits are, over the reference force.
   */
  double admissibility_violation = 0.;
  /** Largest |f_e^t| / (s_e |e|). */
  double max_utilisation = 0.;
  /**
   * Largest residual torque of a cell, over the reference force times the
   * square root of the cell's area. Only blocks that turn balance it.
   */
  double max_torque = 0.;
  /** Certificate::max_torque where they turn, and it is an error; else zero. */
  double moment_residual = 0.;
  /** Scene::load_residual. */
  double load_residual = 0.;
  /** The largest of the residuals and the violation. */
  double error() const
  {
    return std::max(
        {equilibrium_residual, moment_residual, admissibility_violation});
  }
  /** Where error() is, and of what. */
  LargestError largest;
  /**
   * The cells that are out of balance by more than largest_accepted_error of
   * their own force, and by more than the rounding of the forces on them: a
   * small load beside a large one, which the reference force is that of, is
   * judged by itself.
   */
  std::vector<UnbalancedCell> unbalanced;
};

/**
 * The largest residual or violation in a certificate with which a state counts
 * as solved; more only if the user asked for a looser tolerance.
 */
constexpr double largest_accepted_error = 1e-6;

/**
 * The largest Scene::load_residual of a result: what is left where the places
 * of loads are written with few digits, up to a millionth of a cell or a line
 * from where they act.
 */
constexpr double largest_load_residual = 1e-5;

/**
 * The errors of a proof of collapse, by the same rules: the displacements, one
 * for each cell, may be multiplied by any positive number.
 */
struct MechanismCertificate
{
  /**
   * Largest closing of a joint, over the largest displacement of a cell or of
   * an end of a joint with it.
   *
   * The closing is -[u]_e . n_e where that is positive, at the end of the joint
   * that closes more.
   */
  double closing_violation = 0.;
  /** Work of the load over the dissipation of friction; infinite if none. */
  double work_over_dissipation = 0.;
  /**
   * The work that the largest load on a cell would do in all closings, over the
   * work of the load less the dissipation: where it is not small, normal forces
   * of the size of that load could take up the difference.
   */
  double share_of_closing = 0.;
  /** Scene::load_residual. */
  double load_residual = 0.;
};

/**
 * True if the load does more work than friction can dissipate, joints close by
 * rounding only, also beside that work, and the load is that asked for.
 */
bool proves_collapse(const MechanismCertificate &certificate);

/** What a motion proves of the factor of the live loads. */
struct FactorBound
{
  /**
   * No factor above it is carried if the live loads do work, and none below it
   * if they take work: the dissipation of friction less the work of the dead
   * loads, over that of the live loads.
   */
  double factor = 0.;
  /** The work of the live loads; S L times the unit of the motion. */
  double live_work = 0.;
  /** MechanismCertificate::closing_violation. */
  double closing_violation = 0.;
};

/** The proof that no state of a scene has more of a function. */
struct ForceBound
{
  /** The bound; S L, in space S L^2. */
  double bound;
  /**
   * The largest closing of a joint, as in MechanismCertificate: forces without
   * limit resist it, so that it must be rounding.
   */
  double closing_violation;
};

// What certificates in the plane and in space have in common.

/**
 * The reference force of each cell: the largest load on one of its connected
 * group, since groups do not feel each other, nor through the ground, and none
 * may hide behind another. A group without load is judged by the largest of the
 * scene, and a scene without load by the largest force.
 *
 * @param group connected_groups(), where the ground separates.
 * @param load the size of that on each cell.
 * @param largest_force of the interfaces.
 */
std::vector<double> reference_forces(const std::vector<unsigned int> &group,
                                     const std::vector<double> &load,
                                     double largest_force);

/** Errors of forces on cells, over the reference force of each. */
struct RelativeErrors
{
  /** Take one into @p largest, a measure of the certificate. */
  void add(double &largest,
           LargestError::Kind kind,
           double error,
           unsigned int cell);

  /** reference_forces(). */
  const std::vector<double> &reference;
  /** True if cells turn, so that moments are errors. */
  const bool turns;
  /** What has the measures. */
  Certificate &certificate;
};

/** A certificate of forces that are no numbers. */
Certificate infinitely_wrong();

/** What a motion does to a scene, added up. */
struct WorkOfMotion
{
  /** The largest displacement of a cell or of a point of a joint with it. */
  double largest = 0.;
  /** The largest closing of a joint. */
  double closing = 0.;
  /** The sum of the closings of all joints. */
  double all_closings = 0.;
  /** What strengths take out of it. */
  double dissipation = 0.;

  /** MechanismCertificate::closing_violation. */
  double closing_violation() const
  {
    return largest > 0. ? closing / largest : 0.;
  }
};

/**
 * The certificate of a mechanism.
 *
 * @param of what it does.
 * @param work of the loads.
 * @param largest_load on a cell.
 */
MechanismCertificate
certificate_of(const WorkOfMotion &of, double work, double largest_load);

/** What a motion proves of a factor, by the work of the loads along it. */
FactorBound
bound_by(const WorkOfMotion &of, double dead_work, double live_work);
} // namespace Voussoir

#endif
