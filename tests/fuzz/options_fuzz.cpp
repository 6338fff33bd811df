// Any text as options: a line each, "name=value". A value that is taken reads back as one that is
// taken and means the same; one that is refused changes nothing.
#include "session/options.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

using namespace slicecast;

namespace {

std::string allValues(const SessionOptions& options) {
    std::string all;
    for (const OptionInfo& option : knownOptions()) all += optionValue(options, option.name) + "\n";
    return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    SessionOptions options;
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const std::size_t equals = line.find('=');
        const std::string_view name = line.substr(0, equals);
        const std::string_view value =
            equals == std::string_view::npos ? std::string_view() : line.substr(equals + 1);
        const std::string before = allValues(options);
        if (!setOption(options, name, value).empty()) {
            if (allValues(options) != before) std::abort();
            continue;
        }
        if (findOption(name) == nullptr) std::abort();
        const std::string shown = optionValue(options, name);
        const std::string after = allValues(options);
        if (!setOption(options, name, shown).empty() || allValues(options) != after) std::abort();
        static_cast<void>(nextChoice(name, value));
    }
    return 0;
}
