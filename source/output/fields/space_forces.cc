// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/fields/space_forces.h>
#include <voussoir/scene/proofs/space_certificate.h>

#include <memory>
#include <string>
#include <vector>

namespace Voussoir
{
using dealii::Tensor;

namespace
{
const Packing<3>::Interface &face_of(const SpaceResults &a,
                                     const unsigned int e)
{
  return a.scene.packing().interfaces()[e];
}

/** The resultant of an interface, its force along n_e taken apart. */
struct FaceForce
{
  FaceForce(const SpaceResults &a, const unsigned int e)
      : resultant(a.forces.resultant(a.scene.packing(), e)),
        normal(resultant.force * face_of(a, e).normal),
        shear(resultant.force - normal * face_of(a, e).normal)
  {}
  FaceResultant resultant;
  double normal;
  Tensor<1, 3> shear;
};

FieldCondition<SpaceResults> with_forces()
{
  return {"with loads that are carried",
          [](const SpaceResults &a) { return a.is_carried(); }};
}

FieldCondition<SpaceResults> with_motion()
{
  return {"with loads",
          [](const SpaceResults &a) { return !a.motion.displacement.empty(); }};
}

FieldCondition<SpaceResults> with_loads()
{
  return {"with loads", [](const SpaceResults &a) { return a.is_analysed; }};
}

/** The value of a cell that moves, or zero. */
Tensor<1, 3> of_cell(const std::vector<Tensor<1, 3>> &list,
                     const unsigned int c)
{
  return c < list.size() ? list[c] : Tensor<1, 3>();
}

std::vector<std::string> components(const std::string &name)
{
  return {name + "_x", name + "_y", name + "_z"};
}

/** A field of a vector with its three columns. */
template <typename Value>
Field<SpaceResults> vector_field(const std::string &name,
                                 const std::string &unit,
                                 const std::string &words,
                                 const Value &value)
{
  return Field<SpaceResults>(name, unit, words, value)
      .with_columns(components(name));
}

/** A quantity of the jumps of interfaces, found once for all of them. */
template <typename Of>
auto jumps_by(const Of &of)
{
  return [of](const SpaceResults &a) {
    const auto jumps = std::make_shared<const std::vector<FaceJump>>(
        jumps_of_faces(*a.scene.blocks, a.motion));
    return [jumps, of](const unsigned int e) { return of((*jumps)[e]); };
  };
}

/** A quantity of the force on an interface. */
template <typename Of>
auto force_by(const Of &of)
{
  return [of](const SpaceResults &a, const unsigned int e) {
    return of(FaceForce(a, e), face_of(a, e));
  };
}
} // namespace

Fields<SpaceResults> face_forces()
{
  using Interface = Packing<3>::Interface;
  return when<SpaceResults>(
      with_forces(),
      {Field<SpaceResults>(
           "normal_force", "S L^2",
           "the force on c- along n_e, negative in compression",
           force_by([](const FaceForce &force, const Interface &) {
             return force.normal;
           })),
       vector_field("shear_force", "S L^2", "the force on c- across n_e",
                    force_by([](const FaceForce &force, const Interface &) {
                      return force.shear;
                    })),
       vector_field(
           "moment", "S L^3",
           "the moment of the forces on c- about the centroid of the polygon",
           force_by([](const FaceForce &force, const Interface &) {
             return force.resultant.moment;
           })),
       vector_field(
           "eccentricity", "L",
           "from the centroid to the place of the resultant in the polygon; "
           "zero where nothing presses",
           force_by([](const FaceForce &force, const Interface &i) {
             // n x (r x N n) = N (r - (r . n) n).
             return force.normal < 0.
                        ? cross_product_3d(i.normal, force.resultant.moment) /
                              force.normal
                        : Tensor<1, 3>();
           })),
       Field<SpaceResults>(
           "normal_stress", "S", "the normal force over |e|",
           force_by([](const FaceForce &force, const Interface &i) {
             return force.normal / i.area;
           }))
           .only_in_grid(),
       Field<SpaceResults>(
           "utilisation", "",
           "the size of the shear force over c_e |e| + mu_e N, the strength "
           "against sliding",
           [](const SpaceResults &a, const unsigned int e) {
             return utilisation_of_face(*a.scene.blocks, a.forces, e);
           })});
}

namespace
{
/** Strengths in tables, if the scene has them. @param words when. */
Fields<SpaceResults> strengths_when(const std::string &words,
                                    std::vector<double> Strengths::*const of,
                                    Field<SpaceResults> field)
{
  return when<SpaceResults>({words,
                             [of](const SpaceResults &a) {
                               return a.is_analysed &&
                                      !(a.scene.blocks->strengths.*of).empty();
                             }},
                            {field.only_in_table()});
}
} // namespace

Fields<SpaceResults> face_strengths()
{
  const auto of = [](std::vector<double> Strengths::*const member) {
    return [member](const SpaceResults &a) {
      return Stored(a.scene.blocks->strengths.*member);
    };
  };
  return together<SpaceResults>(
      {strengths_when("with loads", &Strengths::of_interface,
                      {"strength", "S", "s_e; c_e with Coulomb's friction",
                       of(&Strengths::of_interface)}),
       strengths_when("with Coulomb's friction", &Strengths::coefficient,
                      {"coefficient", "", "mu_e", of(&Strengths::coefficient)}),
       strengths_when(
           "where joints bear tension", &Strengths::tensile,
           {"tensile_strength", "S", "f_t", of(&Strengths::tensile)}),
       strengths_when("where joints crush", &Strengths::compressive,
                      {"compressive_strength", "S",
                       "f_c, inf where an interface does not",
                       of(&Strengths::compressive)})});
}

Fields<SpaceResults> face_jumps()
{
  return when<SpaceResults>(
      with_motion(),
      {Field<SpaceResults>(
           "opening", "L",
           "the least opening at a vertex, negative where blocks approach",
           jumps_by([](const FaceJump &jump) { return jump.least_opening; })),
       Field<SpaceResults>(
           "sliding", "L", "the largest size of the sliding at a vertex",
           jumps_by([](const FaceJump &jump) { return jump.largest_slip; }))});
}

Fields<SpaceResults> polyhedron_loads()
{
  return when<SpaceResults>(
      with_loads(),
      {vector_field("load", "S L^2", "the sum of the loads on it",
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.scene.loads.force, c);
                    })
           .with_attribute("loads"),
       vector_field("torque", "S L^3", "their moment about its centre",
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.scene.loads.torque, c);
                    })
           .with_attribute("load_torque")});
}

Fields<SpaceResults> loads_on_faces()
{
  using OnFace = SpaceLoads::OnFace;
  const auto of_face = [](Tensor<1, 3> OnFace::*const of) {
    return [of](const SpaceResults &a) {
      return Stored(a.scene.loads.on_faces, of);
    };
  };
  return only_in_table(when<SpaceResults>(
      {"with loads on the boundary",
       [](const SpaceResults &a) {
         return a.is_analysed && !a.scene.loads.on_faces.empty();
       }},
      {vector_field("force", "S L^2", "the force of the traction on it",
                    of_face(&OnFace::force))
           .with_attribute("boundary_forces"),
       vector_field("moment", "S L^3", "the moment of that about the centroid",
                    of_face(&OnFace::moment))
           .with_attribute("boundary_moments")}));
}

Fields<SpaceResults> polyhedron_live_loads()
{
  return only_in_table(when<SpaceResults>(
      {"of a load factor",
       [](const SpaceResults &a) { return a.live && a.is_mechanism; }},
      {vector_field("live_load", "S L^2",
                    "the loads that the factor multiplies; `load` is all at "
                    "the factor that is carried",
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.live->force, c);
                    }),
       vector_field("live_torque", "S L^3", "their moment about its centre",
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.live->torque, c);
                    })}));
}

Fields<SpaceResults> polyhedron_motion()
{
  const std::string words =
      "displacement of the centre: of elastic joints with the modulus 1, or of "
      "the mechanism, of any size";
  return when<SpaceResults>(
      with_motion(),
      {vector_field("displacement", "L", words,
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.motion.displacement, c);
                    })
           .at(FieldDescription::Place::points)
           .saying_in_grid("of each point, with the rotation"),
       vector_field("rotation", "",
                    "the vector of the angle, in the unit of the displacement "
                    "over one of length; zero where blocks do not turn",
                    [](const SpaceResults &a, const unsigned int c) {
                      return of_cell(a.motion.rotation, c);
                    })});
}
} // namespace Voussoir
