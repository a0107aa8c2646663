// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polyhedra_contacts_edge_pair_h
#define voussoir_packing_polyhedra_contacts_edge_pair_h

#include <voussoir/packing/polyhedra/contacts/cell_edges.h>
#include <voussoir/packing/polyhedra/contacts/edge_contact.h>
#include <voussoir/packing/polyhedra/contacts/face_outline.h>

#include <deal.II/base/array_view.h>

#include <array>
#include <vector>

namespace Voussoir
{
/** Two cells that may touch with edges and vertices; one object, used once. */
class EdgePair
{
public:
  /**
   * @param geometry must outlive this object.
   * @param cells the two, the lower number first.
   */
  EdgePair(const FaceGeometry &geometry,
           const std::array<unsigned int, 2> &cells);

  /** Let a polygon in which the faces of the two touch take its place. */
  void add_patch(const dealii::ArrayView<const dealii::Point<3>> &polygon);
  /** Find the joints: along edges, then of vertices and of crossing edges. */
  std::vector<EdgeContact> joints();
  /** True if parallel edges meet, or vertices edges or vertices. */
  bool meets_without_normal() const;

private:
  using Segment = std::array<dealii::Point<3>, 2>;
  using Normal = dealii::Tensor<1, 3>;
  /** A polygon that has taken its place, with its normal. */
  struct Taken
  {
    std::vector<dealii::Point<3>> polygon;
    Normal normal;
  };

  Segment segment(const CellEdge &edge) const;
  void add_along(unsigned int k, const CellEdge &edge, unsigned int face);
  void add_strip(unsigned int k,
                 const CellEdge &edge,
                 const FaceOutline &outline,
                 unsigned int face,
                 const SegmentPart &part);
  void add_vertices(unsigned int k);
  void add_vertex(unsigned int k,
                  const std::vector<const CellEdge *> &edges,
                  unsigned int vertex,
                  unsigned int face);
  void add_crossing(const CellEdge &one, const CellEdge &other);
  void add(const std::array<unsigned int, 2> &faces,
           const Normal &normal,
           std::vector<dealii::Point<3>> polygon,
           bool is_in_point);
  /** The parts of a part of a segment that are not along what is taken. */
  std::vector<SegmentPart> free_parts(const Segment &segment,
                                      const SegmentPart &part,
                                      const Normal &normal) const;
  bool is_taken(const dealii::Point<3> &place) const;
  /** How wide a joint between faces is; a length. */
  double joint_width(const std::vector<unsigned int> &faces) const;

  const FaceGeometry &geometry;
  /** The faces and edges of each that are near to the other. */
  std::array<std::vector<unsigned int>, 2> faces;
  std::array<std::vector<CellEdge>, 2> edges;
  std::array<SpaceBox, 2> boxes;
  std::vector<Taken> taken;
  std::vector<EdgeContact> found;
};
} // namespace Voussoir

#endif
