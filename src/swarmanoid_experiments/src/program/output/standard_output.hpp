/// Writes to standard output: the requested text is written completely, or the program reports that it was not.
#pragma once

#include <string>

namespace swarmanoid::program {

/// Opens /dev/null in place of each closed standard stream; otherwise the next opened file would get its number, and
/// with it the output of the stream. Must be called before any other file is opened.
/// @return whether standard output was open
bool fillStandardStreams();

/// Writes the text at once to the standard output at the time of fillStandardStreams, even if users' code has closed
/// the stream since.
/// @throws std::runtime_error if writing fails
void print(const std::string& text);

}  // namespace swarmanoid::program
