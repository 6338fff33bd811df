// Foreign text for a terminal: names and texts of a scene must not steer it.
#pragma once

#include <string>
#include <string_view>

namespace slicecast {

// The text with "?" for each control character and for each byte that is not of UTF-8: a terminal
// might obey either.
std::string printable(std::string_view text);

}  // namespace slicecast
