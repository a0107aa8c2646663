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
  /** All layers but those that are off or frozen, without other names. */
  LayerChoice() = default;
  /**
   * @param names "pier, arch *": only these, and also if they are off or
   *   frozen; empty: all that are not.
   * @param groups "arch ?: voussoir | pier: abutment": the groups of the cells
   *   on some layers, of which the first that fits counts.
   * @throws InputError if these are not of this form.
   */
  LayerChoice(const std::string &names, const std::string &groups);

  /** True unless all is read, under the names that it has. */
  bool asks() const { return !names.empty() || !groups.empty(); }

  /**
   * Whether a feature of @p layer is read; keeps the names of layers for
   * messages.
   *
   * @param is_hidden true if it is off, frozen or invisible.
   */
  bool takes(const std::string &layer, bool is_hidden);
  /** The group of cells on @p layer, if none is named @p otherwise. */
  std::string group_of(const std::string &layer,
                       const std::string &otherwise) const;

  /**
   * Look whether all names were those of layers.
   *
   * @throws InputError naming the first that was none, and all layers.
   */
  void check(const std::string &file) const;
  /** A notice on features that were left out as hidden; empty if none were. */
  std::string left_out(const std::string &file) const;
  /** What to do if nothing was read, as a part of a sentence. */
  std::string hint() const;

private:
  /** A layer, and how many features of it were met. */
  struct Layer
  {
    std::string name;
    bool is_taken = false;
    unsigned int n_hidden = 0;
  };

  /** The names of layers, in the order of the file, that are @p taken. */
  std::string listed(bool only_taken) const;
  std::string listed_hidden() const;

  std::vector<std::string> names;
  std::vector<std::pair<std::string, std::string>> groups;
  std::vector<Layer> layers;
};
} // namespace Voussoir

#endif
