#include "base/printable.h"
#include "base/words.h"
#include "scene/scene.h"

namespace slicecast {

std::string describe(const Fault& fault) {
    std::string text = fault.file;
    if (fault.line > 0) add(text, {":", fault.line, ":", fault.column});
    if (!fault.pointer.empty()) {
        add(text, {" (", fault.pointer});
        if (fault.row >= 0) add(text, {", row ", fault.row, ", character ", fault.character});
        add(text, ")");
    }
    add(text, {": found ", fault.found, ", expected ", fault.expected});
    return printable(text);
}

}  // namespace slicecast
