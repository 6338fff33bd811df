#include "scene/json_tree.h"

#include "base/sort.h"
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
        pointer =
            words("/", parent.isObject() ? escapedKey(JsonValue(node).key()) : words(node->place),
                  pointer);
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
    std::vector<const JsonNode*> members;
    std::vector<const JsonNode*> room;
    for (const JsonNode& node : nodes) {
        const JsonValue value(&node);
        if (!value.isObject() || value.count() < 2) continue;
        members.clear();
        for (const JsonValue member : value) members.push_back(member.node_);
        mergeSort(members, room, [](const JsonNode* a, const JsonNode* b) {
            return JsonValue(a).key() < JsonValue(b).key();
        });
        const JsonNode* first = members[0];
        for (std::size_t i = 1; i < members.size(); ++i) {
            if (JsonValue(members[i]).key() == JsonValue(first).key()) {
                duplicates.emplace_back(members[i], first);
            } else {
                first = members[i];
            }
        }
    }
    return duplicates;
}

}  // namespace slicecast
