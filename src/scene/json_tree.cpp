#include "scene/json_tree.h"

#include <algorithm>
#include <unordered_map>

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

JsonValue::Kind JsonValue::kind() const {
    return tree_->nodes[node_].kind;
}

bool JsonValue::boolean() const {
    return tree_->nodes[node_].boolean;
}

double JsonValue::number() const {
    return tree_->nodes[node_].number;
}

std::string_view JsonValue::text() const {
    const JsonTree::Node& node = tree_->nodes[node_];
    return std::string_view(tree_->characters).substr(node.text.start, node.text.length);
}

std::string_view JsonValue::key() const {
    const JsonTree::Node& node = tree_->nodes[node_];
    return std::string_view(tree_->characters).substr(node.keyStart, node.keyLength);
}

std::size_t JsonValue::offset() const {
    return tree_->nodes[node_].offset;
}

std::size_t JsonValue::keyOffset() const {
    return tree_->nodes[node_].keyOffset;
}

std::string JsonValue::pointer() const {
    std::string pointer;
    for (std::uint32_t node = node_; node != 0; node = tree_->nodes[node].parent) {
        const JsonValue parent(tree_, tree_->nodes[node].parent);
        std::string step;
        if (parent.isObject()) {
            step = escapedKey(JsonValue(tree_, node).key());
        } else {
            int index = 0;
            for (const JsonValue sibling : parent) {
                if (sibling.node_ == node) break;
                ++index;
            }
            step = std::to_string(index);
        }
        pointer = "/" + step + pointer;
    }
    return pointer;
}

JsonValue::Iterator& JsonValue::Iterator::operator++() {
    node_ = tree_->nodes[node_].end;
    return *this;
}

JsonValue::Iterator JsonValue::end() const {
    return {tree_, tree_->nodes[node_].end};
}

std::size_t JsonValue::count() const {
    return tree_->nodes[node_].count;
}

std::optional<JsonValue> JsonValue::find(std::string_view wanted) const {
    for (const JsonValue member : *this) {
        if (member.key() == wanted) return member;
    }
    return std::nullopt;
}

std::vector<std::pair<JsonValue, JsonValue>> JsonTree::duplicateKeys() const {
    std::vector<std::pair<JsonValue, JsonValue>> duplicates;
    for (std::uint32_t node = 0; node < nodes.size(); ++node) {
        const JsonValue value(this, node);
        if (!value.isObject() || value.count() < 2) continue;
        std::unordered_map<std::string_view, JsonValue> firsts;
        for (const JsonValue member : value) {
            const auto [first, isNew] = firsts.emplace(member.key(), member);
            if (!isNew) duplicates.emplace_back(member, first->second);
        }
    }
    return duplicates;
}

}  // namespace slicecast
