// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_packing_polygons_layer_choice_h
#define voussoir_packing_polygons_layer_choice_h

#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * The layers of a drawing that are read, and what the cells on them are called.
 * Names may have the wildcards of a shell: *, ? and [abc].
 */
class LayerChoice
{
public:
  /** All layers, without other names. */
  LayerChoice() = default;
  /**
   * @param names "pier, arch *": only these; empty: all.
   * @param groups "arch ?: voussoir | pier: abutment": the groups of the cells
   *   on some layers, of which the first that fits counts.
   * @throws InputError if these are not of this form.
   */
  LayerChoice(const std::string &names, const std::string &groups);

  /** True unless all is read, under the names that it has. */
  bool asks() const { return !names.empty() || !groups.empty(); }

  /** Whether a feature of @p layer is read; keeps its name for messages. */
  bool takes(const std::string &layer);
  /** The group of cells on @p layer, if none is named @p otherwise. */
  std::string group_of(const std::string &layer,
                       const std::string &otherwise) const;

  /**
   * Look whether all names were those of layers.
   *
   * @throws InputError naming the first that was none, and all layers.
   */
  void check(const std::string &file) const;

private:
  /** A layer of which a feature was met. */
  struct Layer
  {
    std::string name;
    bool is_taken = false;
  };

  /** The names of layers, in the order of the file, that are @p taken. */
  std::string listed(bool only_taken) const;

  std::vector<std::string> names;
  std::vector<std::pair<std::string, std::string>> groups;
  std::vector<Layer> layers;
};
} // namespace Voussoir

#endif
