// Collects what is wrong with a scene, and the checks that many parts of a scene share. Every check
// that fails reports its own fault, so that one pass over the tree finds all of them.
#pragma once

#include "base/later_text.h"
#include "base/named.h"
#include "base/words.h"
#include "scene/json_tree.h"
#include "scene/names.h"
#include "scene/scene.h"
#include "scene/source_text.h"
#include "slicecast/colour.h"

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicecast {

// low <= v <= high, or low < v <= high with `aboveLow`. `words` say so in messages.
struct NumberRange {
    double low;
    double high;
    bool aboveLow;
    const char* words;
};
inline constexpr NumberRange kUnitRange = {0.0, 1.0, false, "a number from 0 to 1"};

// A text in quotes, shortened if it is long.
std::string quoted(std::string_view text);

// `"a", "b" or "c"`
std::string listed(const std::vector<std::string_view>& texts);

class Fields;
class NameUses;

class Checker {
public:
    Checker(const SourceText& source, std::string file) : source_(source), file_(std::move(file)) {}

    const SourceText& source() const { return source_; }

    // Faults so far; a part of the tree is sound if none was added while it was read.
    std::size_t count() const { return faults_.size() + omitted_ + awaiting_; }
    // From now on it is noted in `uses` which names have been asked for.
    void noteUses(NameUses& uses) { uses_ = &uses; }
    const NameUses* uses() const { return uses_; }

    // The names that a table may have which is still to come; `count` has them too.
    std::size_t awaiting() const { return awaiting_; }

    // Each reports a fault: at a value, at the key of a member, and for a key that an object has a
    // second time.
    void add(JsonValue at, const Words& found, const Words& expected);
    void addAtKey(JsonValue member, const Words& found, const Words& expected);
    // The same with plain texts, which take less code at each call.
    void add(JsonValue at, const char* found, const char* expected);
    void add(JsonValue at, const Words& found, const char* expected);
    void addAtKey(JsonValue member, const char* found, const char* expected);
    void addSecondKey(JsonValue again, JsonValue first);
    // The same; `found` is the value itself, as shown() puts it.
    void refuse(JsonValue value, const Words& expected);
    void refuse(JsonValue value, const char* expected);
    // In a row of a grid: `row` and `character` count from 0 in the north and west.
    void addInRow(JsonValue text, int row, int character, const Words& found,
                  const Words& expected);
    void addSyntax(const SyntaxFault& fault);
    // For what loads, but is probably a mistake.
    void warn(JsonValue at, const Words& found, const Words& expected);
    void warn(JsonValue at, const char* found, const char* expected);
    // One that is given to nobody yet.
    Fault faultAt(JsonValue at, const Words& found = "", const Words& expected = "") const;

    // All faults, or warnings, in the order of the text. The checker forgets them.
    std::vector<Fault> take();
    std::vector<Fault> takeWarnings();

    // What a value is, for a message: `the text "north"`, `the number 1.5`, `an array of 3
    // elements`.
    std::string shown(JsonValue value) const;

    // The members of an object; `known` are its keys besides "comment" and "data". Reports unknown
    // keys. Nothing if the value is no object, which is reported as not `expected`.
    std::optional<Fields> fields(JsonValue value, std::span<const std::string_view> known,
                                 LaterText expected);
    std::optional<Fields> fields(JsonValue value, std::initializer_list<std::string_view> known,
                                 LaterText expected);

    // Each of these reads a value. Reports a value of another kind or outside the range, and
    // returns nothing.
    std::optional<double> number(JsonValue value, const NumberRange& range);
    std::optional<int> wholeNumber(JsonValue value, const NumberRange& range);
    std::optional<bool> flag(JsonValue value);
    // A text of 1 to `longest` characters; `expected` says what it is.
    std::optional<std::string> text(JsonValue value, std::size_t longest, const Words& expected);
    // The number that the table has for a name; `what` is its kind in messages: "texture".
    std::optional<std::uint16_t> name(JsonValue value, const NameTable& names, const char* what);
    // "#rrggbb"
    std::optional<Colour> colour(JsonValue value);
    // The key of a member, which names it.
    void checkName(JsonValue member);

private:
    struct Placed {
        std::size_t offset;
        std::size_t number;  // order in which they were found
        Fault fault;
    };
    // Of a name that the table does not have.
    std::optional<std::uint16_t> nameElsewhere(JsonValue value, const NameTable& names,
                                               const char* what);
    void addUnknownKey(JsonValue member, std::span<const std::string_view> known, Fields& fields);
    // True if kMaxFaults have been reported: then counts one more, which needs no message.
    bool onlyCounts();
    void addAt(std::vector<Placed>& list, std::size_t offset, const JsonValue* at, int row,
               int character, const Words& found, const Words& expected);
    static std::vector<Fault> inOrder(std::vector<Placed> list);

    const SourceText& source_;
    std::string file_;
    std::vector<Placed> faults_;
    std::vector<Placed> warnings_;
    std::size_t omitted_ = 0;
    std::size_t awaiting_ = 0;
    NameUses* uses_ = nullptr;
};

// The members of an object whose keys have been checked. The readers return the fallback if there
// is no such member. They report a faulty member, and return the fallback too.
class Fields {
public:
    Fields(Checker& checker, JsonValue object) : checker_(&checker), object_(object) {}

    // Lets a misspelt key, which is reported already, count as the known `key` that it resembles.
    // So that one is not reported as missing too.
    void addMisspelt(std::string_view key, JsonValue member) {
        misspelt_.emplace_back(key, member);
    }

    FoundValue find(const char* key) const;
    // The same; reports a missing member.
    FoundValue require(const char* key, const char* expected) const;

    double number(const char* key, const NumberRange& range, double fallback) const;
    int wholeNumber(const char* key, const NumberRange& range, int fallback) const;
    bool flag(const char* key, bool fallback) const;
    Colour colour(const char* key, Colour fallback) const;
    // The number of the "map"; nothing for an unknown one.
    std::optional<std::uint16_t> mapOr(const NameTable& maps, int fallback) const;
    // The value of a name of the table.
    template <typename Value, std::size_t count>
    Value choice(const char* key, const Named<Value> (&table)[count], Value fallback) const {
        const FoundValue member = find(key);
        if (!member) return fallback;
        const std::optional<Value> value =
            valueOf(table, member->isText() ? member->text() : std::string_view());
        if (!value) checker_->refuse(*member, listedNames(table));
        return value.value_or(fallback);
    }
    template <typename Value, std::size_t count>
    void requireChoice(const char* key, const Named<Value> (&table)[count]) const {
        require(key, listedNames(table).c_str());
    }

private:
    template <typename Value, std::size_t count>
    static std::string listedNames(const Named<Value> (&table)[count]) {
        std::vector<std::string_view> names;
        for (const Named<Value>& named : table) names.emplace_back(named.name);
        return listed(names);
    }

    Checker* checker_;
    JsonValue object_;
    std::vector<std::pair<std::string_view, JsonValue>> misspelt_;
};

inline std::optional<Fields> Checker::fields(JsonValue value,
                                             std::initializer_list<std::string_view> known,
                                             LaterText expected) {
    return fields(value, std::span(known.begin(), known.size()), expected);
}

// The last entry of a list of faults: says that `count` others are left out.
Fault moreFaults(const std::string& file, std::size_t count);

}  // namespace slicecast
