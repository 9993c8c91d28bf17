/// Standard output: what is asked for goes there whole, or the program says that it did not.
#pragma once

#include <string>

namespace swarmanoid::program {

/// Opens /dev/null in the place of each standard stream that is closed; else the next file that is opened would have
/// its number, and get what is meant for the stream. Before anything else opens a file.
/// @return whether standard output was open
bool fillStandardStreams();

/// Writes the text to what was standard output then, at once, even if users' code has closed that since.
/// @throws std::runtime_error if it cannot be written
void print(const std::string& text);

}  // namespace swarmanoid::program
