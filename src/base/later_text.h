// Texts that a page needs only after a mistake: its first part does not hold them
// (tools/split-program.mjs).
//
//     checker.add(value, "a start outside the map"_later, ...)
//     LaterText text = "a lamp"_onFault;      // not read before it is called:
//     checker.refuse(value, wordsOf(text));
//
// Elsewhere it is a text like others. In the page it is a function, of the later part, that writes
// the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace slicecast {

// The characters of a literal, with the zero at its end.
template <std::size_t size>
struct LiteralText {
    consteval LiteralText(const char (&literal)[size]) {
        for (std::size_t i = 0; i < size; ++i) characters[i] = literal[i];
    }
    char characters[size] = {};
};

#ifdef __wasm__

namespace later_text {

// Each write is a number within the code: no data.
template <LiteralText text, std::size_t at>
void writeCharacter(char* place) {
    constexpr char kCharacter = text.characters[at];
    place[at] = kCharacter;
}
template <LiteralText text, std::size_t... at>
void writeAll(char* place, std::index_sequence<at...>) {
    (writeCharacter<text, at>(place), ...);
}

}  // namespace later_text

template <LiteralText text>
__attribute__((noinline)) const char* operator""_later() {
    static char place[sizeof text.characters];
    later_text::writeAll<text>(place, std::make_index_sequence<sizeof place>());
    return place;
}

using LaterText = const char* (*)();
template <LiteralText text>
constexpr LaterText operator""_onFault() {
    return &operator""_later<text>;
}
inline const char* wordsOf(LaterText text) {
    return text();
}

#else

template <LiteralText text>
constexpr const char* operator""_later() {
    return text.characters;
}

using LaterText = const char*;
template <LiteralText text>
constexpr LaterText operator""_onFault() {
    return text.characters;
}
inline const char* wordsOf(LaterText text) {
    return text;
}

#endif

}  // namespace slicecast
