// JSON text as a small tree of values that remember where they stand, so that a fault can name its place.
//
//     ParsedJson json = parseJson(source);
//     if (json.fault) ...                                 // the text is not JSON: one fault, no tree
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

class JsonTree;

// A value of a tree: a handle, cheap to copy, valid as long as its tree.
class JsonValue {
public:
    enum class Kind : std::uint8_t { null, boolean, number, text, array, object };

    JsonValue(const JsonTree* tree, std::uint32_t node) : tree_(tree), node_(node) {}

    Kind kind() const;
    bool isObject() const { return kind() == Kind::object; }
    bool isArray() const { return kind() == Kind::array; }
    bool isText() const { return kind() == Kind::text; }

    bool boolean() const;           // of a boolean
    double number() const;          // of a number
    std::string_view text() const;  // of a text, escapes resolved
    std::string_view key() const;   // of a member of an object
    std::size_t offset() const;     // of the value's first byte
    std::size_t keyOffset() const;  // of the opening quote of a member's key
    std::string pointer() const;    // JSON pointer, "" for the root

    // Children of an array or object, in order.
    class Iterator {
    public:
        Iterator(const JsonTree* tree, std::uint32_t node) : tree_(tree), node_(node) {}
        JsonValue operator*() const { return {tree_, node_}; }
        Iterator& operator++();
        bool operator!=(const Iterator& other) const { return node_ != other.node_; }

    private:
        const JsonTree* tree_;
        std::uint32_t node_;
    };
    Iterator begin() const { return {tree_, node_ + 1}; }
    Iterator end() const;
    std::size_t count() const;

    // The first member of an object with this key.
    std::optional<JsonValue> find(std::string_view wanted) const;

private:
    const JsonTree* tree_;
    std::uint32_t node_;
};

class JsonTree {
public:
    struct TextRange {
        std::uint32_t start;  // in `characters`
        std::uint32_t length;
    };

    // Values stand in the order of the text, a container before its children.
    struct Node {
        JsonValue::Kind kind = JsonValue::Kind::null;
        bool boolean = false;
        std::uint32_t offset = 0;
        std::uint32_t keyOffset = 0;
        std::uint32_t keyStart = 0;  // in `characters`
        std::uint32_t keyLength = 0;
        std::uint32_t parent = 0;  // the root is its own parent
        std::uint32_t end = 0;     // the node behind the last descendant
        union {
            double number = 0.0;
            TextRange text;
            std::uint32_t count;  // children
        };
    };

    JsonValue root() const { return {this, 0}; }

    // The members whose key stood in their object before, each with the first one of that key.
    std::vector<std::pair<JsonValue, JsonValue>> duplicateKeys() const;

    std::vector<Node> nodes;
    std::string characters;  // of all texts and keys
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
