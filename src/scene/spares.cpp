#include "scene/spares.h"

#include "base/later_text.h"
#include "scene/readers.h"

#include <algorithm>

namespace slicecast {
namespace {

using Signs = NameIndex;

void addSigns(JsonValue text, Signs& signs) {
    for (std::size_t offset = 0; offset < text.text().size();)
        signs.add(takeSign(text.text(), offset), 0);
}

void addSignsOfRows(FoundValue rows, Signs& signs) {
    if (!rows) return;
    for (const JsonValue row : *rows) addSigns(row, signs);
}

// Of rows, of what fills a level, and of levels that repeat.
void addSignsOfLevels(FoundValue levels, Signs& signs) {
    if (!levels) return;
    for (const JsonValue level : *levels) {
        if (level.isArray()) {
            addSignsOfRows(level, signs);
            continue;
        }
        addSignsOfLevels(level.find("levels"), signs);
        addSignsOfRows(level.find("rows"), signs);
        const FoundValue filling = level.find("fill");
        if (!filling) continue;
        if (filling->isText()) {
            addSigns(*filling, signs);
            continue;
        }
        for (const JsonValue rectangle : *filling) addSigns(*rectangle.find("character"), signs);
    }
}

class SpareFinder {
public:
    SpareFinder(Reading& reading, const NameUses& uses)
        : reading_(reading), uses_(uses), stands_(standingBlocks(reading.description.world)) {}

    void findNames(FoundValue table, const NameTable& names, const char* found,
                   const char* expected) {
        if (!table) return;
        for (const JsonValue member : *table) {
            if (!uses_.has(names, member.key())) add(member, found, expected);
        }
    }

    void findCharacters(FoundValue legend, const Signs& signs) {
        if (!legend) return;
        for (const JsonValue member : *legend) {
            if (signs.find(member.key())) continue;
            add(member, "a character of the legend that no row has"_later,
                "the character in a row, or no such member"_later);
        }
    }

    // Not those of blueprints that stand nowhere, which are told as such.
    void findCharactersOfBlocks(FoundValue legend, Signs signs) {
        if (!legend) return;
        for (const JsonValue member : *legend) {
            const auto id = reading_.blueprints.find(member.text());
            if (id && !stands_[*id]) signs.add(member.key(), 0);
        }
        findCharacters(legend, signs);
    }

    // "legend" with "tiles" or "rows"
    void findCharactersOfGrid(FoundValue grid, const char* rows) {
        if (!grid || !grid->isObject()) return;
        Signs signs;
        addSignsOfRows(grid->find(rows), signs);
        findCharacters(grid->find("legend"), signs);
    }

private:
    void add(JsonValue at, const char* found, const char* expected) {
        reading_.addAim(Aim::What::spare, at, 0);
        Fault& fault = reading_.description.aims.back().place;
        fault.found = found;
        fault.expected = expected;
    }

    Reading& reading_;
    const NameUses& uses_;
    std::vector<bool> stands_;  // by BlueprintId
};

}  // namespace

std::vector<bool> standingBlocks(const World& world) {
    std::vector<bool> stands(world.blueprints.size());
    for (const Map& map : world.maps) {
        for (const BlueprintId id : map.cells)
            stands[id] = stands[world.blueprints[id].origin] = true;
    }
    return stands;
}

void NameUses::note(const NameTable& table, std::string_view name) {
    auto at = std::find_if(ofTables_.begin(), ofTables_.end(),
                           [&](const auto& one) { return one.first == &table; });
    if (at == ofTables_.end()) at = ofTables_.insert(at, {&table, {}});
    at->second.add(name, 0);
}

bool NameUses::has(const NameTable& table, std::string_view name) const {
    return std::any_of(ofTables_.begin(), ofTables_.end(), [&](const auto& one) {
        return one.first == &table && one.second.find(name);
    });
}

void findSpares(Reading& reading, JsonValue root, const NameUses& uses) {
    SpareFinder finder(reading, uses);
    finder.findNames(root.find("textures"), reading.textures, "a texture that nothing shows"_later,
                     "its name on a block or a floor, or no such texture"_later);
    finder.findNames(root.find("sprites"), reading.sprites, "a sprite that nothing shows"_later,
                     "its name in an object, or no such sprite"_later);
    finder.findNames(root.find("motions"), reading.motions, "a motion that moves nothing"_later,
                     "its name in a blueprint, or no such motion"_later);
    const FoundValue ofScene = root.find("legend");
    Signs used;  // that mean what it says
    const JsonValue maps = *root.find("maps");
    for (const JsonValue map : maps) {
        Signs signs;
        addSignsOfLevels(map.find("levels"), signs);
        const FoundValue own = map.find("legend");
        finder.findCharactersOfBlocks(own, signs);
        finder.findCharactersOfGrid(map.find("floor"), "tiles");
        finder.findCharactersOfGrid(map.find("ceiling"), "tiles");
        finder.findCharactersOfGrid(map.find("objectRows"), "rows");
        if (!ofScene) continue;
        for (const JsonValue member : *ofScene)
            if (signs.find(member.key()) && (!own || !own->find(member.key())))
                used.add(member.key(), 0);
    }
    finder.findCharactersOfBlocks(ofScene, std::move(used));
}

}  // namespace slicecast
