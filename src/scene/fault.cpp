#include "scene/scene.h"

namespace slicecast {

std::string describe(const Fault& fault) {
    std::string words = fault.file;
    if (fault.line > 0) words += ":" + std::to_string(fault.line) + ":" + std::to_string(fault.column);
    if (!fault.pointer.empty()) {
        words += " (" + fault.pointer;
        if (fault.row >= 0) words += ", row " + std::to_string(fault.row) + ", character " + std::to_string(fault.character);
        words += ")";
    }
    return words + ": found " + fault.found + ", expected " + fault.expected;
}

}  // namespace slicecast
