// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_base_text_file_h
#define voussoir_base_text_file_h

#include <filesystem>
#include <optional>
#include <string>

namespace Voussoir
{
/** All that a file has; none if it cannot be read, as a directory. */
std::optional<std::string> bytes_of_file(const std::filesystem::path &file);

/**
 * The text of a file as UTF-8: without the byte order mark that some editors
 * put before it, and with a line feed for every end of a line of Windows.
 *
 * @return none if the file cannot be read.
 * @throws InputError naming the file if it is in UTF-16.
 */
std::optional<std::string> read_text_file(const std::filesystem::path &file);
} // namespace Voussoir

#endif
