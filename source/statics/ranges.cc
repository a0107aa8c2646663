// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/algebra/vectors.h>
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/scene/certificate.h>
#include <voussoir/scene/force_function.h>
#include <voussoir/scene/reactions.h>
#include <voussoir/statics/ranges.h>
#include <voussoir/statics/state_program.h>

#include <deal.II/base/parallel.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <mutex>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
/**
 * The functions are shared out in so many parts, whatever the number of cores,
 * so that results do not depend on it.
 */
constexpr unsigned int n_parts = 8;
/** The functions are normal and tangential forces, or x and y, in turn. */
constexpr unsigned int n_kinds = 2;

/** What proofs may leave to rounding. */
constexpr double largest_error_of_state = 1e-9, largest_closing = 1e-9,
                 largest_width = 1e-9;
/** What a ray leaves on a body, over its largest force. */
constexpr double rounding_of_ray = 1e-9;

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Their ranges are looked for, function by function. */
class Search
{
public:
  Search(const Scene &scene,
         const std::vector<ForceFunction> &functions,
         Terminal &terminal);

  /** Find all; the result has a range for each function. */
  std::vector<Range> find_all();
  /** The largest errors so far, in the part of Ranges about proofs. */
  Ranges proofs;

private:
  void find_part(StateProgram &program, unsigned int begin, unsigned int end);
  /** A value with both proofs. */
  struct Proven
  {
    /** Of the state, or infinity. */
    double value;
    /** Of the motion. */
    ForceBound bound;
    /** Certificate::error() of the state. */
    double error_of_state;

    /** What the bound is more than the value; zero if there is none. */
    double width() const
    {
      return value < infinity ? bound.bound - value : 0.;
    }
    /** @param reference the force that small differences are relative to. */
    bool is_good(const double reference) const
    {
      return error_of_state <= largest_error_of_state &&
             bound.closing_violation <= largest_closing &&
             width() <= largest_width * std::max(reference, std::abs(value));
    }
  };
  Proven greatest(StateProgram &program, const ForceFunction &function) const;
  double judged(StateProgram &program,
                const ForceFunction &function,
                Ranges &proofs) const;
  std::vector<double> coefficients(const ForceFunction &function) const;
  bool is_ray(const std::vector<double> &x) const;

  const Scene &scene;
  const std::vector<ForceFunction> &functions;
  Terminal &terminal;
  const DiscreteProblem problem;
  RowProblem by_rows;
  std::vector<Range> found;
  std::size_t n_done = 0;
  std::mutex mutex;
};

Search::Search(const Scene &scene,
               const std::vector<ForceFunction> &functions,
               Terminal &terminal)
    : scene(scene), functions(functions), terminal(terminal), problem(scene),
      by_rows(problem), found(functions.size())
{
  for (const dealii::Tensor<1, 2> &load : scene.load)
    proofs.reference = std::max(proofs.reference, load.norm());
}

std::vector<double> Search::coefficients(const ForceFunction &function) const
{
  std::vector<double> c(by_rows.rows().n_all_rows(), 0.);
  const unsigned int n = problem.n_contacts();
  for (const ForceFunction::Term &term : function.terms)
  {
    for (unsigned int r = 0; r < 2; ++r)
      by_rows.rows().add_force(term.interface, std::min(r, n - 1),
                               term.at_ends[r] / (n == 1 ? 2. : 1.), c);
    by_rows.rows().add_force(term.interface, n, term.tangential, c);
  }
  return c;
}

bool Search::is_ray(const std::vector<double> &x) const
{
  return largest_component(by_rows.forces().on_bodies(x)) <=
         rounding_of_ray * largest_component(x);
}

/** The greatest value of a function and its proofs, or infinity. */
Search::Proven Search::greatest(StateProgram &program,
                                const ForceFunction &function) const
{
  const std::vector<double> c = coefficients(function);
  StateProgram::Optimum optimum = program.maximise(c);
  if (!optimum.is_found)
    throw SolverError("The linear programme of a range has no answer: the "
                      "load may be close to what the packing can carry. Choose "
                      "fewer interfaces by 'Ranges/Where', or none.");
  if (optimum.is_unbounded)
  {
    if (!is_ray(optimum.x) || !(dot(c, optimum.x) > 0.))
      throw SolverError("The linear programme of a range has no bound, and no "
                        "forces that balance by themselves prove that. Choose "
                        "other interfaces by 'Ranges/Where', or none.");
    return {infinity, {infinity, 0.}, 0.};
  }
  Solution state;
  state.forces = by_rows.rows().forces_of(optimum.x);
  const InterfaceForces forces = dimensional_forces(problem, state);
  optimum.u.resize(problem.n_dofs());
  return {function(forces),
          bound_of(scene, function, problem.motion_of_cells(optimum.u, 1.)),
          certify(scene, forces).error()};
}

/**
 * The same. Now and then Clp ends before the optimum, and goes on if it is
 * asked again; or rounding has spoilt its factors.
 */
double Search::judged(StateProgram &program,
                      const ForceFunction &function,
                      Ranges &proofs) const
{
  const double reference = this->proofs.reference;
  Proven found = greatest(program, function);
  if (!found.is_good(reference))
    found = greatest(program, function);
  if (!found.is_good(reference))
  {
    program.forget();
    found = greatest(program, function);
  }
  if (!found.is_good(reference))
    throw SolverError(text(
        "The range of a force is not proven: its state has an error of ",
        found.error_of_state,
        " of the largest load, its motion closes joints by ",
        found.bound.closing_violation, " of its size, and they differ by ",
        found.width(),
        ". Choose other interfaces by 'Ranges/Where', or none."));
  ++proofs.n_programmes;
  proofs.error_of_states =
      std::max(proofs.error_of_states, found.error_of_state);
  proofs.closing_violation =
      std::max(proofs.closing_violation, found.bound.closing_violation);
  proofs.width = std::max(proofs.width, found.width());
  return found.value;
}

/**
 * The kinds of functions one after the other, and all maxima before all minima,
 * so that each programme ends close to where the next one does.
 */
void Search::find_part(StateProgram &program,
                       const unsigned int begin,
                       const unsigned int end)
{
  Ranges of_part;
  for (unsigned int kind = 0; kind < n_kinds; ++kind)
    for (const double sign : {1., -1.})
      for (unsigned int k = begin; k < end; ++k)
      {
        if (k % n_kinds != kind)
          continue;
        const double value =
            sign * judged(program, functions[k].times(sign), of_part);
        (sign > 0. ? found[k].greatest : found[k].least) = value;
        const std::lock_guard<std::mutex> lock(mutex);
        terminal.progress(++n_done, 2 * functions.size(), "programmes");
      }
  const std::lock_guard<std::mutex> lock(mutex);
  proofs.width = std::max(proofs.width, of_part.width);
  proofs.closing_violation =
      std::max(proofs.closing_violation, of_part.closing_violation);
  proofs.error_of_states =
      std::max(proofs.error_of_states, of_part.error_of_states);
  proofs.n_programmes += of_part.n_programmes;
  proofs.n_iterations += program.n_iterations();
}

std::vector<Range> Search::find_all()
{
  StateProgram first(by_rows);
  if (!first.find_state())
    throw SolverError("The ranges of forces have no state to start from: the "
                      "load is close to what the packing can carry. Set "
                      "'Ranges/Where = 0' to have the state alone.");
  const auto begin_of = [&](const unsigned int part) {
    return static_cast<unsigned int>(std::size_t(part) * functions.size() /
                                     n_parts);
  };
  dealii::parallel::apply_to_subranges(
      0U, n_parts,
      [&](const unsigned int begin, const unsigned int end) {
        for (unsigned int part = begin; part < end; ++part)
        {
          StateProgram program(first);
          find_part(program, begin_of(part), begin_of(part + 1));
        }
      },
      1);
  proofs.n_iterations += first.n_iterations();
  return found;
}

/**
 * The numbers of the interfaces that are wanted, in the order of a curve of
 * Hilbert through their midpoints: of neighbours the programmes end in vertices
 * that are close to each other.
 */
std::vector<unsigned int> along_curve(const Packing &packing,
                                      const std::vector<bool> &wanted)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<std::pair<Kernel::Point_2, unsigned int>> places;
  for (unsigned int e = 0; e < wanted.size(); ++e)
    if (wanted[e])
    {
      const dealii::Point<2> x = packing.interfaces()[e].midpoint();
      places.push_back({{x[0], x[1]}, e});
    }
  using Map = CGAL::First_of_pair_property_map<decltype(places)::value_type>;
  CGAL::hilbert_sort(places.begin(), places.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>());
  std::vector<unsigned int> numbers;
  for (const auto &place : places)
    numbers.push_back(place.second);
  return numbers;
}
} // namespace

Ranges
find_ranges(const Scene &scene, const RangesWanted &wanted, Terminal &terminal)
{
  const std::vector<unsigned int> interfaces =
      along_curve(scene.packing, wanted.interfaces);
  std::vector<ForceFunction> functions;
  for (const unsigned int e : interfaces)
  {
    functions.push_back(normal_force(e));
    functions.push_back(tangential_force(e));
  }
  std::vector<StraightRun> supports;
  if (wanted.reactions)
    supports = straight_supports(scene.packing);
  for (const StraightRun &support : supports)
    for (unsigned int i = 0; i < 2; ++i)
    {
      dealii::Tensor<1, 2> direction;
      direction[i] = 1.;
      functions.push_back(reaction(scene.packing, support, direction));
    }

  Search search(scene, functions, terminal);
  const std::vector<Range> found = search.find_all();
  Ranges ranges = search.proofs;
  ranges.wanted = wanted.interfaces;
  ranges.normal.resize(wanted.interfaces.size());
  ranges.tangential.resize(wanted.interfaces.size());
  auto next = found.begin();
  for (const unsigned int e : interfaces)
  {
    ranges.normal[e] = *next++;
    ranges.tangential[e] = *next++;
  }
  for (unsigned int s = 0; s < supports.size(); ++s, next += 2)
    ranges.reactions.push_back({{next[0], next[1]}});
  return ranges;
}
} // namespace Voussoir
