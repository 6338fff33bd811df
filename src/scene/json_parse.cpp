// Text to tree, by RapidJSON's SAX reader.
#include "base/number_text.h"
#include "base/words.h"
#include "scene/json_tree.h"
#include "scene/limits.h"

// RapidJSON 1.1 adds to a null pointer in a comparison when its stack is first used. The result is
// right, so the sanitizer skips it.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((no_sanitize("pointer-overflow"))), apply_to = function)
#endif
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>
#if defined(__clang__)
#pragma clang attribute pop
#endif

#include <algorithm>
#include <cmath>

namespace slicecast {
namespace {

constexpr std::size_t kLongestWord = 30;  // in a message
constexpr const char* kHalfPair = "half of a surrogate pair";
constexpr const char* kWholePair = "both halves, as in \\ud83e\\uddf1";

// Builds the tree from the reader's events. An event lacks the offset of its token, which is found
// from the end of the token before: only white space, a comma or a colon can stand between.
class TreeBuilder {
public:
    using Ch = char;

    TreeBuilder(std::string_view text, const rapidjson::MemoryStream& stream, JsonTree& tree)
        : text_(text), stream_(stream), tree_(tree) {}

    // RapidJSON calls these by name.
    // NOLINTBEGIN(readability-identifier-naming)
    bool Null() { return addScalar(JsonValue::Kind::null); }
    bool Bool(bool value) {
        if (!addScalar(JsonValue::Kind::boolean)) return false;
        tree_.nodes.back().boolean = value;
        return true;
    }
    // All numbers come as text (kParseNumbersAsStringsFlag); the other callbacks are never called.
    bool RawNumber(const char* characters, rapidjson::SizeType length, bool) {
        const double number = readNumber({characters, length}).value_or(0.0);
        if (!std::isfinite(number)) {
            fault = {tokenStart(),
                     std::string(characters, std::min<std::size_t>(length, kLongestWord)),
                     "a finite number, at most about 1.8e308"};
            return false;
        }
        if (!addScalar(JsonValue::Kind::number)) return false;
        tree_.nodes.back().number = number;
        return true;
    }
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }
    bool String(const char* characters, rapidjson::SizeType length, bool) {
        if (!isWellFormed({characters, length}) || !addScalar(JsonValue::Kind::text)) return false;
        tree_.nodes.back().text = keep(characters, length);
        return true;
    }
    bool Key(const char* characters, rapidjson::SizeType length, bool) {
        if (!isWellFormed({characters, length})) return false;
        keyOffset_ = tokenStart();
        key_ = keep(characters, length);
        end_ = stream_.Tell();
        return true;
    }
    bool StartObject() { return open(JsonValue::Kind::object); }
    bool StartArray() { return open(JsonValue::Kind::array); }
    bool EndObject(rapidjson::SizeType) { return close(); }
    bool EndArray(rapidjson::SizeType) { return close(); }
    // NOLINTEND(readability-identifier-naming)

    // The first byte of the token that comes next, or is being read.
    std::size_t tokenStart() const {
        const std::size_t start = text_.find_first_not_of(" \t\r\n,:", end_);
        return std::min(start, text_.size());
    }

    // Set where a callback has stopped the reader.
    std::optional<SyntaxFault> fault;

private:
    bool add(JsonValue::Kind kind) {
        if (tree_.nodes.size() >= kMaxSceneValues) {
            fault = {tokenStart(), words("more than ", kMaxSceneValues, " values"),
                     "fewer numbers, texts, rows, arrays and objects"};
            return false;
        }
        JsonNode node;
        node.kind = kind;
        node.offset = static_cast<std::uint32_t>(tokenStart());
        if (!open_.empty()) {
            JsonNode& parent = tree_.nodes[open_.back()];
            node.up = static_cast<std::uint32_t>(tree_.nodes.size()) - open_.back();
            if (parent.kind == JsonValue::Kind::object) {
                node.place = static_cast<std::uint32_t>(keyOffset_);
                node.key = key_;
            } else {
                node.place = parent.count;
            }
            ++parent.count;
        }
        tree_.nodes.push_back(node);
        return true;
    }

    bool addScalar(JsonValue::Kind kind) {
        if (!add(kind)) return false;
        end_ = stream_.Tell();
        return true;
    }

    bool open(JsonValue::Kind kind) {
        if (open_.size() >= static_cast<std::size_t>(kMaxNesting)) {
            fault = {tokenStart(),
                     words("arrays and objects nested more than ", kMaxNesting, " deep"),
                     "less nesting: a scene needs 5"};
            return false;
        }
        if (!add(kind)) return false;
        JsonNode& node = tree_.nodes.back();
        node.count = 0;
        open_.push_back(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
        end_ = node.offset + 1;
        return true;
    }

    bool close() {
        tree_.nodes[open_.back()].nodes =
            static_cast<std::uint32_t>(tree_.nodes.size()) - open_.back();
        open_.pop_back();
        end_ = tokenStart() + 1;
        return true;
    }

    // RapidJSON refuses the first half of a surrogate pair without the second, but not the second
    // without the first.
    bool isWellFormed(std::string_view characters) {
        for (std::size_t at = characters.find('\xed'); at != std::string_view::npos;
             at = characters.find('\xed', at + 1)) {
            if (utf8Length(characters, at) > 0) continue;
            fault = {tokenStart(), kHalfPair, kWholePair};
            return false;
        }
        return true;
    }

    // Never reallocates: no string is longer than its spelling in the file.
    JsonNode::TextRange keep(const char* characters, std::size_t length) {
        const std::size_t start = tree_.characters.size();
        tree_.characters.insert(tree_.characters.end(), characters, characters + length);
        return {tree_.characters.data() + start, static_cast<std::uint32_t>(length)};
    }

    std::string_view text_;
    const rapidjson::MemoryStream& stream_;
    JsonTree& tree_;
    std::vector<std::uint32_t> open_;  // containers that are not closed yet
    std::size_t end_ = 0;              // of the last token
    std::size_t keyOffset_ = 0;
    JsonNode::TextRange key_ = {nullptr, 0};
};

bool isWordCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("+-._").find(c) != std::string_view::npos;
}

// The word or character at an offset, as a message shows it.
std::string shown(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return "the end of the file";
    std::size_t end = offset;
    while (end < text.size() && end < offset + kLongestWord && isWordCharacter(text[end])) ++end;
    if (end > offset) return std::string(text.substr(offset, end - offset));
    if (static_cast<unsigned char>(text[offset]) < 0x20) return "a control character";
    if (text[offset] == '\'') return "a single quote";
    return words(
        "'", text.substr(offset, static_cast<std::size_t>(std::max(1, utf8Length(text, offset)))),
        "'");
}

bool standsAt(std::string_view text, std::size_t offset, std::string_view wanted) {
    return offset <= text.size() && text.substr(offset, wanted.size()) == wanted;
}

// The fault of whatever stands at `offset` in place of `expected`; after a comma, in place of
// `another` value or key.
SyntaxFault explainMissing(std::string_view text, std::size_t offset, std::string expected,
                           const char* another = nullptr) {
    std::string found = shown(text, offset);
    if (standsAt(text, offset, "/")) {
        expected += "; JSON has no comments";
    } else if (standsAt(text, offset, "'") || standsAt(text, offset, "\xe2\x80\x9c")) {
        expected += "; texts and keys need plain double quotes";
    } else if (another && (standsAt(text, offset, "]") || standsAt(text, offset, "}"))) {
        const std::size_t before = text.substr(0, offset).find_last_not_of(" \t\r\n");
        if (before != std::string_view::npos && text[before] == ',') {
            found = words("a comma before ", found);
            expected = words(another, " after the comma, or no comma");
        }
    }
    return {offset, found, expected};
}

// The fault of two keys, or two values, with nothing between them; it lies where the comma is
// missing. Otherwise that of explainMissing.
SyntaxFault explainComma(std::string_view text, std::size_t offset, std::string_view starts,
                         const char* next, std::string expected) {
    if (offset >= text.size() || starts.find(text[offset]) == std::string_view::npos)
        return explainMissing(text, offset, std::move(expected));
    const std::size_t before = text.substr(0, offset).find_last_not_of(" \t\r\n");
    return {before + 1, "no comma", words("a comma before the next ", next)};
}

SyntaxFault explainValue(std::string_view text, std::size_t offset) {
    for (const std::string_view word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
        if (standsAt(text, offset, word)) return {offset, shown(text, offset), "a finite number"};
    }
    if (standsAt(text, offset, "+"))
        return {offset, shown(text, offset), "a number without a plus sign"};
    if (standsAt(text, offset, "."))
        return {offset, shown(text, offset), "a number that starts with a digit, as in 0.5"};
    if (standsAt(text, offset, "True") || standsAt(text, offset, "False")) {
        return {offset, shown(text, offset), "true or false in lower case"};
    }
    return explainMissing(text, offset,
                          "a value: a text in double quotes, a number, true, false, [ or {",
                          "another value");
}

// `token` is the start of the token that was being read, `offset` where the reader stopped.
SyntaxFault explain(std::string_view text, rapidjson::ParseErrorCode code, std::size_t offset,
                    std::size_t token) {
    switch (code) {
        case rapidjson::kParseErrorDocumentEmpty:
            if (token < text.size()) return explainValue(text, token);
            return {offset, "an empty file", "a scene: an object in { }"};
        case rapidjson::kParseErrorDocumentRootNotSingular:
            return explainMissing(text, offset, "the end of the file");
        case rapidjson::kParseErrorValueInvalid:
            return explainValue(text, token);
        case rapidjson::kParseErrorObjectMissName:
            return explainMissing(text, offset,
                                  standsAt(text, offset, "[") || standsAt(text, offset, "{")
                                      ? "a key in double quotes; was an array closed too early?"
                                      : "a key in double quotes",
                                  "another key");
        case rapidjson::kParseErrorObjectMissColon:
            return explainMissing(text, offset, "a colon between key and value");
        case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
            return explainComma(text, offset, "\"", "key",
                                "a comma and the next key, or } at the end of the object");
        case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
            return explainComma(text, offset, "\"[{-0123456789", "value",
                                "a comma and the next value, or ] at the end of the array");
        case rapidjson::kParseErrorStringMissQuotationMark:
        case rapidjson::kParseErrorStringInvalidEncoding:
            return {token, "a text that is not closed", "a double quote at its end"};
        case rapidjson::kParseErrorStringEscapeInvalid: {
            const bool isControl =
                offset < text.size() && static_cast<unsigned char>(text[offset]) < 0x20;
            if (!isControl)
                return {offset, "a backslash without a valid escape",
                        "\\\" \\\\ \\/ \\b \\f \\n \\r \\t or \\u and four hex digits"};
            if (text[offset] == '\t') return {offset, "a tab within a text", "spaces, or \\t"};
            return {token, "a text that is not closed at the end of its line",
                    "a double quote at its end"};
        }
        case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
            return {offset, "\\u without four hex digits", "four hex digits, as in \\u2588"};
        case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
            return {offset, kHalfPair, kWholePair};
        case rapidjson::kParseErrorNumberTooBig:
            return {offset, shown(text, offset), "a finite number, at most about 1.8e308"};
        case rapidjson::kParseErrorNumberMissFraction:
            return {token, shown(text, token), "a number with digits after its decimal point"};
        case rapidjson::kParseErrorNumberMissExponent:
            return {token, shown(text, token), "a number with digits in its exponent"};
        default:
            return {offset, shown(text, offset), "JSON"};
    }
}

}  // namespace

ParsedJson parseJson(const SourceText& source) {
    ParsedJson parsed;
    const std::string_view text = source.text().substr(source.start());
    rapidjson::MemoryStream stream(text.data(), text.size());
    TreeBuilder builder(text, stream, parsed.tree);
    parsed.tree.characters.reserve(text.size());

    rapidjson::Reader reader;
    const rapidjson::ParseResult result =
        reader.Parse<rapidjson::kParseNumbersAsStringsFlag | rapidjson::kParseIterativeFlag>(
            stream, builder);
    if (builder.fault) {
        parsed.fault = builder.fault;
    } else if (result.IsError()) {
        parsed.fault = explain(text, result.Code(), result.Offset(), builder.tokenStart());
    } else if (stream.Tell() != text.size()) {
        // The reader takes a zero byte for the end of the text.
        parsed.fault = SyntaxFault{stream.Tell(), "a zero byte", "the end of the file"};
    }
    if (parsed.fault) parsed.fault->offset += source.start();
    for (JsonNode& node : parsed.tree.nodes) {
        node.offset += static_cast<std::uint32_t>(source.start());
        if (node.key.start != nullptr) node.place += static_cast<std::uint32_t>(source.start());
    }
    return parsed;
}

}  // namespace slicecast
