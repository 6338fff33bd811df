#include "files/print_line.h"

#include "base/printable.h"

#include <string>

namespace slicecast {

void printLine(std::FILE* to, const Words& line) {
    const std::string text = printable(line.str()) + '\n';
    std::fwrite(text.data(), 1, text.size(), to);
}

}  // namespace slicecast
