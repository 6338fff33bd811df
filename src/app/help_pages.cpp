#include "app/help_pages.h"

#ifndef __EMSCRIPTEN__

#include "base/words.h"
#include "overlay/layout.h"
#include "overlay/text.h"

#include <algorithm>
#include <string_view>

namespace slicecast {

namespace {

// Room for a panel's text at the smallest scale.
struct Room {
    int width = 0;  // pixels
    int lines = 0;
};

Room roomIn(Size picture) {
    const int around = 2 * (kPanelPadding + overlayMargin(picture.width, picture.height));
    return {picture.width - around,
            std::max(2, (picture.height - around + kLineAdvance - kGlyphHeight) / kLineAdvance)};
}

// Breaks the text at `width`; further lines are indented below its start, beside no key.
std::vector<std::string> wrapText(const std::string& keys, std::string_view text, int width) {
    std::vector<std::string> lines = {keys + '\t'};
    bool isFirst = true;  // of its line
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string longer = lines.back() + (isFirst ? "" : " ") + std::string(word);
        if (isFirst || textWidth(longer) <= width) {
            lines.back() = longer;
        } else {
            lines.push_back('\t' + std::string(word));
        }
        isFirst = false;
    }
    return lines;
}

}  // namespace

std::vector<std::string> helpPages(const KeyBindings& keys, Size picture) {
    const Room room = roomIn(picture);
    std::vector<std::vector<std::string>> entries;
    int count = 0;
    for (const KeyHelp& line : keys.help()) {
        if (line.keys.empty() || isOfPagesOnly(line.first)) continue;
        entries.push_back(wrapText(keysText(line), line.does, room.width));
        count += static_cast<int>(entries.back().size());
    }

    // All pages but the last are equally long. With several pages, the last line of each shows its
    // number.
    const bool isOne = count <= room.lines;
    const int most = isOne ? count : room.lines - 1;
    const int pages = (count + most - 1) / std::max(1, most);
    const int aim = (count + pages - 1) / std::max(1, pages);
    std::vector<std::string> texts;
    int lines = 0;
    for (const std::vector<std::string>& entry : entries) {
        const int longer = lines + static_cast<int>(entry.size());
        if (texts.empty() || longer > most || lines >= aim) {
            texts.emplace_back();
            lines = 0;
        }
        for (const std::string& line : entry) {
            texts.back() += (lines == 0 ? "" : "\n") + line;
            ++lines;
        }
    }
    const KeyPosition* key = keys.keyOf(Action::help);
    const std::string_view label = key != nullptr ? key->label : "";
    for (std::size_t i = 0; i < texts.size() && texts.size() > 1; ++i)
        texts[i] += words("\n", label, "\tpage ", i + 1, " of ", texts.size());
    return texts;
}

}  // namespace slicecast

#endif
