// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/polygons/line_work.h>

#include <CGAL/Arr_consolidated_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <set>

namespace Voussoir
{
namespace
{
using dealii::Point;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_consolidated_curve_data_traits_2<
    CGAL::Arr_segment_traits_2<Kernel>,
    unsigned int>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Halfedge = Arrangement::Halfedge_const_handle;

Point<2> place_of(const Arrangement::Vertex_const_handle &vertex)
{
  // Exactly, so that it does not depend on what was asked before.
  return {CGAL::to_double(vertex->point().x().exact()),
          CGAL::to_double(vertex->point().y().exact())};
}

std::vector<unsigned int> sources_of(const Halfedge &edge)
{
  std::vector<unsigned int> sources(edge->curve().data().begin(),
                                    edge->curve().data().end());
  std::sort(sources.begin(), sources.end());
  return sources;
}

bool is_loose(const Halfedge &edge)
{
  return edge->face() == edge->twin()->face();
}

/** A bounded face; without the loose pieces that reach into it. */
LineFace face_of(const Arrangement::Face_const_handle &face)
{
  LineFace found;
  found.has_hole = false;
  const auto begin = face->outer_ccb();
  auto edge = begin;
  do
    if (!is_loose(edge))
    {
      found.ring.push_back(place_of(edge->source()));
      found.sources.push_back(sources_of(edge));
    }
  while (++edge != begin);
  for (auto hole = face->holes_begin(); hole != face->holes_end(); ++hole)
    found.has_hole |= !is_loose(*hole);
  std::set<unsigned int> all;
  for (const auto &of_side : found.sources)
    all.insert(of_side.begin(), of_side.end());
  found.all_sources.assign(all.begin(), all.end());
  return found;
}

/** The first loose piece of each line, at best one that ends freely. */
std::vector<LooseLine> loose_lines(const Arrangement &arrangement)
{
  std::map<unsigned int, LooseLine> loose;
  for (auto edge = arrangement.edges_begin(); edge != arrangement.edges_end();
       ++edge)
  {
    if (!is_loose(edge))
      continue;
    const bool at_source = edge->source()->degree() == 1,
               is_free = at_source || edge->target()->degree() == 1;
    const Point<2> place =
        place_of(at_source ? edge->source() : edge->target());
    for (const unsigned int source : sources_of(edge))
    {
      const auto [known, is_new] =
          loose.emplace(source, LooseLine{source, place, is_free});
      if (!is_new && is_free && !known->second.ends_freely)
        known->second = {source, place, true};
    }
  }
  std::vector<LooseLine> all;
  for (const auto &[source, line] : loose)
    all.push_back(line);
  return all;
}
} // namespace

LineFaces faces_of(const std::vector<LinePiece> &pieces)
{
  std::vector<Traits::Curve_2> curves;
  for (const LinePiece &piece : pieces)
    curves.emplace_back(Kernel::Segment_2({piece.start[0], piece.start[1]},
                                          {piece.end[0], piece.end[1]}),
                        piece.source);
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());

  LineFaces found;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end();
       ++face)
    if (!face->is_unbounded() && !face->is_fictitious())
      found.faces.push_back(face_of(face));
  std::stable_sort(found.faces.begin(), found.faces.end(),
                   [&](const LineFace &a, const LineFace &b) {
                     return a.all_sources < b.all_sources;
                   });
  found.loose = loose_lines(arrangement);
  return found;
}
} // namespace Voussoir
