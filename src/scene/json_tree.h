// JSON text as a small tree of values that remember where they stand, so that a fault can name its
// place.
//
//     ParsedJson json = parseJson(source);
//     if (json.fault) ...                  // the text is not JSON: one fault, no tree
//     JsonValue root = json.tree.root();
//     for (JsonValue member : root) member.key() ...
//
// Duplicate keys are kept; `duplicateKeys` lists them.
#pragma once

#include "scene/source_text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// A stored value. Values follow the order of the text, a container before its children.
struct JsonNode {
    enum class Kind : std::uint8_t { null, boolean, number, text, array, object };
    struct TextRange {
        const char* start;
        std::uint32_t length;
    };

    Kind kind = Kind::null;
    bool boolean = false;
    std::uint32_t offset = 0;
    std::uint32_t place = 0;  // of a member: the offset of its key; of an element of an array: how
                              // many stand before it
    TextRange key = {nullptr, 0};
    std::uint32_t up = 0;     // nodes from its parent to it; 0 for the root
    std::uint32_t nodes = 1;  // itself and all its descendants, which follow it
    union {
        double number = 0.0;
        TextRange text;
        std::uint32_t count;  // children
    };
};

class FoundValue;

// A value of a tree: a handle of one pointer, valid as long as its tree.
class JsonValue {
public:
    using Kind = JsonNode::Kind;

    explicit JsonValue(const JsonNode* node) : node_(node) {}

    Kind kind() const { return node_->kind; }
    bool isObject() const { return kind() == Kind::object; }
    bool isArray() const { return kind() == Kind::array; }
    bool isText() const { return kind() == Kind::text; }

    bool boolean() const { return node_->boolean; }  // of a boolean
    double number() const { return node_->number; }  // of a number
    std::string_view text() const {
        return {node_->text.start, node_->text.length};
    }  // of a text, escapes resolved
    std::string_view key() const {
        return {node_->key.start, node_->key.length};
    }                                                     // of a member of an object
    std::size_t offset() const { return node_->offset; }  // of the value's first byte
    std::size_t keyOffset() const {
        return node_->place;
    }                                                   // of the opening quote of a member's key
    std::size_t count() const { return node_->count; }  // of the children of an array or object
    std::string pointer() const;                        // JSON pointer, "" for the root

    // Children of an array or object, in order.
    class Iterator {
    public:
        explicit Iterator(const JsonNode* node) : node_(node) {}
        JsonValue operator*() const { return JsonValue(node_); }
        Iterator& operator++() {
            node_ += node_->nodes;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return node_ != other.node_; }

    private:
        const JsonNode* node_;
    };
    Iterator begin() const { return Iterator(node_ + 1); }
    Iterator end() const { return Iterator(node_ + node_->nodes); }

    // The first member of an object with this key.
    FoundValue find(std::string_view wanted) const;

private:
    friend class FoundValue;
    friend struct JsonTree;
    const JsonNode* node_;
};

// A value that may be missing, used like a std::optional.
class FoundValue {
public:
    FoundValue() : value_(nullptr) {}
    FoundValue(JsonValue value) : value_(value) {}
    explicit operator bool() const { return value_.node_ != nullptr; }
    const JsonValue& operator*() const { return value_; }
    const JsonValue* operator->() const { return &value_; }

private:
    JsonValue value_;
};

// Nodes point into the characters: a tree can be moved, but not copied.
struct JsonTree {
    JsonTree() = default;
    JsonTree(JsonTree&&) = default;
    JsonTree& operator=(JsonTree&&) = default;

    JsonValue root() const { return JsonValue(nodes.data()); }

    // The members whose key stood in their object before, each with the first one of that key.
    std::vector<std::pair<JsonValue, JsonValue>> duplicateKeys() const;

    std::vector<JsonNode> nodes;
    std::vector<char> characters;  // of all texts and keys
};

// Why a text is not JSON.
struct SyntaxFault {
    std::size_t offset = 0;
    std::string found;
    std::string expected;
};

struct ParsedJson {
    JsonTree tree;
    std::optional<SyntaxFault> fault;
};

// Reads a text that is well-formed UTF-8 and no longer than kMaxSceneBytes.
ParsedJson parseJson(const SourceText& source);

}  // namespace slicecast
