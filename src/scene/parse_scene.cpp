#include "base/name_index.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr NumberRange kPortalLimit = {0.0, kMaxPortalLimit, false,
                                      "a whole number of portals, from 0 to 32"};
static_assert(kMaxPortalLimit == 32, "as the words say");

// Reads every part of the tree, even after faults in earlier ones.
void readScene(Reading& reading, JsonValue root) {
    Checker& checker = reading.checker;
    const auto fields =
        checker.fields(root,
                       {"$schema", "title", "textures", "sprites", "motions", "blueprints",
                        "legend", "maps", "portalLimit", "game", "start"},
                       "a scene: an object with \"title\", \"textures\", \"maps\" and \"start\"");
    if (!fields) return;
    if (const auto schema = fields->find("$schema"))
        checker.text(*schema, kMaxPathLength, "the address of the schema");
    if (const auto title = fields->require("title", "the name of the scene")) {
        reading.description.world.title =
            checker.text(*title, kMaxTitleLength, "the name of the scene").value_or("");
    }

    const std::size_t faultsBefore = checker.count();
    if (const auto textures = fields->require("textures", "a PNG file for each texture's name")) {
        readTextures(reading, *textures);
    } else {
        reading.textures.takeAny();
    }
    if (const auto sprites = fields->find("sprites")) readSprites(reading, *sprites);
    if (const auto motions = fields->find("motions")) readMotions(reading, *motions);
    if (const auto blueprints = fields->find("blueprints")) readBlueprints(reading, *blueprints);
    Legend legend(kEmptyCell, kEmptyCell);
    if (const auto own = fields->find("legend"))
        readLegend(checker, *own, reading.blueprints, "blueprint", legend);
    reading.areBlueprintsSound = checker.count() == faultsBefore;

    if (const auto maps = fields->require("maps", "an array of maps")) {
        readMaps(reading, *maps, legend);
    } else {
        reading.maps.takeAny();
    }
    if (const auto limit = fields->find("portalLimit")) {
        reading.description.world.portalLimit =
            checker.wholeNumber(*limit, kPortalLimit).value_or(kDefaultPortalLimit);
    }
    placePortals(reading);
    if (const auto maps = fields->find("maps")) placeMovers(reading, *maps);
    if (const auto start = fields->require("start", "where the player starts"))
        readStart(reading, *start);
    placePaths(reading);
    placeObjects(reading);
    placeQuest(reading, fields->find("game"));
    if (checker.count() == 0) findHiddenThings(reading);
    const std::vector<Map>& maps = reading.description.world.maps;
    if (reading.lamp &&
        std::none_of(maps.begin(), maps.end(), [](const Map& map) { return map.baked.on; }))
        checker.warn(*reading.lamp, "a lamp, but no map with \"baked\": it does not shine",
                     "\"baked\" in its map");
    placeVariants(reading);
}

// The files that a scene names, each once, in the order of the text.
std::vector<std::string> filesOf(const SceneDescription& description) {
    std::vector<std::string> files;
    NameIndex known;
    const auto add = [&](const ImageReference& image) {
        const auto number = static_cast<std::uint32_t>(files.size());
        if (known.add(image.file, number) == number) files.push_back(image.file);
    };
    for (const TextureReference& texture : description.textures) {
        if (!texture.colour) add(texture.image);
    }
    for (const TextureReference& sprite : description.sprites) add(sprite.image);
    for (const PanoramaReference& panorama : description.panoramas) add(panorama.image);
    return files;
}

}  // namespace

ParsedScene::ParsedScene() = default;
ParsedScene::ParsedScene(ParsedScene&&) noexcept = default;
ParsedScene& ParsedScene::operator=(ParsedScene&&) noexcept = default;
ParsedScene::~ParsedScene() = default;

ParsedScene parseScene(std::string_view text, const std::string& fileName) {
    ParsedScene parsed;
    if (text.size() > kMaxSceneBytes) {
        Fault fault;
        fault.file = fileName;
        fault.found = words("a file of ", text.size(), " bytes");
        fault.expected = words("at most ", kMaxSceneBytes);
        parsed.faults.push_back(std::move(fault));
        return parsed;
    }

    // Text to tree.
    const SourceText source(text);
    Checker checker(source, fileName);
    if (source.invalidByte()) {
        const bool isUtf16 = text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff";
        checker.addSyntax({*source.invalidByte(),
                           isUtf16 ? "a text in UTF-16" : "bytes that are not UTF-8",
                           "a text file saved as UTF-8"});
        parsed.faults = checker.take();
        return parsed;
    }
    const ParsedJson json = parseJson(source);
    if (json.fault) {
        checker.addSyntax(*json.fault);
        parsed.faults = checker.take();
        return parsed;
    }

    // Tree to description.
    for (const auto& [again, first] : json.tree.duplicateKeys()) {
        checker.addSecondKey(again, first);
    }
    auto description = std::make_unique<SceneDescription>();
    description->fileName = fileName;
    Reading reading{checker, *description, {}, {}, {}, {}, false, {}, 0};
    readScene(reading, json.tree.root());
    parsed.faults = checker.take();
    if (parsed.faults.empty()) {
        parsed.warnings = checker.takeWarnings();
        parsed.files = filesOf(*description);
        parsed.description = std::move(description);
    }
    return parsed;
}

}  // namespace slicecast
