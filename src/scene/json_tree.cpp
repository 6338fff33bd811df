#include "scene/json_tree.h"

#include "base/name_index.h"
#include "base/words.h"

namespace slicecast {
namespace {

// A key within a JSON pointer: '~' and '/' are escaped.
std::string escapedKey(std::string_view key) {
    std::string escaped;
    for (const char c : key) {
        if (c == '~') {
            escaped += "~0";
        } else if (c == '/') {
            escaped += "~1";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

}  // namespace

std::string JsonValue::pointer() const {
    std::string pointer;
    for (const JsonNode* node = node_; node->up != 0; node -= node->up) {
        const JsonValue parent(node - node->up);
        std::string step;
        if (parent.isObject()) {
            step = escapedKey(JsonValue(node).key());
        } else {
            int index = 0;
            for (const JsonValue sibling : parent) {
                if (sibling.node_ == node) break;
                ++index;
            }
            step = words(index);
        }
        pointer = words("/", step, pointer);
    }
    return pointer;
}

FoundValue JsonValue::find(std::string_view wanted) const {
    for (const JsonValue member : *this) {
        if (member.key() == wanted) return member;
    }
    return {};
}

std::vector<std::pair<JsonValue, JsonValue>> JsonTree::duplicateKeys() const {
    std::vector<std::pair<JsonValue, JsonValue>> duplicates;
    for (const JsonNode& node : nodes) {
        const JsonValue value(&node);
        if (!value.isObject() || value.count() < 2) continue;
        NameIndex firsts;
        for (const JsonValue member : value) {
            const auto number = static_cast<std::uint32_t>(member.node_ - nodes.data());
            const std::uint32_t first = firsts.add(member.key(), number);
            if (first != number) duplicates.emplace_back(member, JsonValue(&nodes[first]));
        }
    }
    return duplicates;
}

}  // namespace slicecast
