#include "base/later_text.h"
#include "base/name_index.h"
#include "base/task_list.h"
#include "scene/in_the_way.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "scene/spares.h"

#include <algorithm>
#include <utility>

namespace slicecast {
namespace {

constexpr NumberRange kPortalLimit = {0.0, kMaxPortalLimit, false,
                                      "a whole number of portals, from 0 to 32"};
static_assert(kMaxPortalLimit == 32, "as the words say");

// The files that a scene names, each once, in the order of the text.
std::vector<std::string> filesOf(const SceneDescription& description) {
    std::vector<std::string> files;
    NameIndex known;
    const auto add = [&](const ImageReference& image) {
        if (image.file.empty()) return;  // a faulty one
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

struct SceneParser::Work {
    // The table of shipped pictures.
    struct PictureTable {
        PictureTable(std::string_view given, Reading& reading)
            : source(given),
              json(parseJson(source)),
              textures(reading, part("textures"), true),
              sprites(reading, part("sprites"), false) {}
        __attribute__((noinline)) ~PictureTable() {}  // NOLINT: a first picture needs none
        FoundValue part(const char* key) const {
            return json.fault ? FoundValue{} : json.tree.root().find(key);
        }
        SourceText source;
        ParsedJson json;
        ShippedPictures textures;
        ShippedPictures sprites;
    };

    Work(std::string_view given, std::string fileName)
        : text(given),
          source(given.size() <= kMaxSceneBytes ? given : std::string_view()),
          checker(source, fileName) {
        reading.textures.awaitMore();
        reading.sprites.awaitMore();
        description->fileName = std::move(fileName);
        tasks.add<&Work::readText>(*this);
        tasks.add<&Work::finish>(*this);
    }

    void takePictures(std::string_view pictures);
    void addMistakes();
    void readText();
    void readScene();
    void readNames();
    void readMapList();
    void placeThings();
    void placeMoversOfMaps();
    void placeStart();
    void readGame();
    void findMistakes();
    void finish();

    std::string_view text;
    SourceText source;
    Checker checker;
    ParsedJson json;
    std::unique_ptr<SceneDescription> description = std::make_unique<SceneDescription>();
    TaskList tasks;
    Reading reading{checker, *description, tasks, {}, {}, {}, {}, false, {}, 0};
    std::unique_ptr<PictureTable> table;
    std::optional<Fields> fields;  // of the root
    ParsedScene parsed;
};

// Few scenes need it before their picture.
__attribute__((noinline)) void SceneParser::Work::takePictures(std::string_view pictures) {
    table = std::make_unique<PictureTable>(pictures, reading);
    reading.textures.lookIn(table->textures);
    reading.sprites.lookIn(table->sprites);
}

__attribute__((noinline)) void SceneParser::Work::addMistakes() {
    if (checker.count() > 0) return;
    findSpares(reading, json.tree.root(), *checker.uses());
    findThingsInTheWay(reading);
    const auto sprites = fields->find("sprites");
    if (!sprites) return;
    for (const JsonValue member : *sprites) {
        const auto id = reading.sprites.find(member.key());
        const TextureReference& sprite = description->sprites[*id];
        if (sprite.frames == 1 && sprite.views == 1) reading.addAim(Aim::What::sheet, member, *id);
    }
}

// Text to tree.
void SceneParser::Work::readText() {
    if (text.size() > kMaxSceneBytes) {
        Fault fault;
        fault.file = description->fileName;
        fault.found = words("a file of ", text.size(), " bytes");
        fault.expected = words("at most ", kMaxSceneBytes);
        parsed.faults.push_back(std::move(fault));
        return;
    }
    if (source.invalidByte()) {
        const bool isUtf16 = text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff";
        checker.addSyntax({*source.invalidByte(),
                           isUtf16 ? "a text in UTF-16" : "bytes that are not UTF-8"_later,
                           "a text file saved as UTF-8"_later});
        return;
    }
    json = parseJson(source);
    if (json.fault)
        checker.addSyntax(*json.fault);
    else
        tasks.add<&Work::readScene>(*this);
}

// Tree to description. Reads every part of the tree, even after faults in earlier ones.
void SceneParser::Work::readScene() {
    for (const auto& [again, first] : json.tree.duplicateKeys()) checker.addSecondKey(again, first);
    fields = checker.fields(
        json.tree.root(),
        {"$schema", "title", "textures", "sprites", "motions", "blueprints", "legend", "maps",
         "portalLimit", "game", "start"},
        "a scene: an object with \"title\", \"textures\", \"maps\" and \"start\""_onFault);
    if (!fields) return;
    if (const auto schema = fields->find("$schema"))
        checker.text(*schema, kMaxPathLength, "the address of the schema");
    if (const auto title = fields->require("title", "the name of the scene")) {
        description->world.title =
            checker.text(*title, kMaxTitleLength, "the name of the scene").value_or("");
    }
    tasks.add<&Work::readNames>(*this);
    tasks.add<&Work::readMapList>(*this);
    tasks.add<&Work::placeThings>(*this);
}

void SceneParser::Work::readNames() {
    const std::size_t faultsBefore = checker.count();
    if (const auto textures = fields->find("textures")) readTextures(reading, *textures);
    if (const auto sprites = fields->find("sprites")) readSprites(reading, *sprites);
    if (const auto motions = fields->find("motions")) readMotions(reading, *motions);
    if (const auto blueprints = fields->find("blueprints")) readBlueprints(reading, *blueprints);
    if (const auto own = fields->find("legend"))
        readLegend(checker, *own, &reading.blueprints, "blueprint", reading.legend);
    reading.areBlueprintsSound = checker.count() == faultsBefore;
}

void SceneParser::Work::readMapList() {
    if (const auto maps = fields->require("maps", "an array of maps")) {
        readMaps(reading, *maps);
    } else {
        reading.maps.takeAny();
    }
}

// What can be read once all maps are known.
void SceneParser::Work::placeThings() {
    if (const auto limit = fields->find("portalLimit")) {
        description->world.portalLimit =
            checker.wholeNumber(*limit, kPortalLimit).value_or(kDefaultPortalLimit);
    }
    tasks.add<placePortals>(reading);
    tasks.add<&Work::placeMoversOfMaps>(*this);
    tasks.add<&Work::placeStart>(*this);
    tasks.add<placeObjects>(reading);
    tasks.add<&Work::readGame>(*this);
    tasks.add<&Work::findMistakes>(*this);
    tasks.add<placeVariants>(reading);
}

void SceneParser::Work::placeMoversOfMaps() {
    if (const auto maps = fields->find("maps")) placeMovers(reading, *maps);
}

void SceneParser::Work::placeStart() {
    if (const auto start = fields->require("start", "where the player starts"))
        readStart(reading, *start);
    placePaths(reading);
}

void SceneParser::Work::readGame() {
    placeQuest(reading, fields->find("game"));
}

void SceneParser::Work::findMistakes() {
    if (checker.count() == 0) findHiddenThings(reading);
    for (const Places& each : reading.places) {
        for (const NamedPlace& place : each.places)
            if (!place.isUsed) reading.addAim(Aim::What::place, place.value, 0);
    }
    const std::vector<Map>& maps = description->world.maps;
    if (reading.lamp &&
        std::none_of(maps.begin(), maps.end(), [](const Map& map) { return map.baked.on; }))
        checker.warn(*reading.lamp, "a lamp, but no map with \"baked\": it does not shine"_later,
                     "\"baked\" in its map"_later);
    if (checker.uses() != nullptr) addMistakes();
}

void SceneParser::Work::finish() {
    for (Fault& fault : checker.take()) parsed.faults.push_back(std::move(fault));
    if (!fields) return;
    if (parsed.faults.empty()) parsed.warnings = checker.takeWarnings();
    parsed.files = filesOf(*description);
    parsed.description = std::move(description);
}

SceneParser::SceneParser(std::string_view text, std::string fileName)
    : work_(std::make_unique<Work>(text, std::move(fileName))) {}
SceneParser::SceneParser(SceneParser&&) noexcept = default;
SceneParser& SceneParser::operator=(SceneParser&&) noexcept = default;
SceneParser::~SceneParser() = default;

void SceneParser::takePictures(std::string_view table) {
    work_->takePictures(table);
}

void SceneParser::lookForMistakes(NameUses& uses) {
    work_->checker.noteUses(uses);
}

bool SceneParser::next() {
    if (work_->checker.awaiting() == 0) return work_->tasks.doNext();
    work_->parsed.needsPictures = true;
    return false;
}

double SceneParser::share() const {
    return work_->tasks.share();
}

ParsedScene SceneParser::take() {
    return std::move(work_->parsed);
}

ParsedScene parseScene(std::string_view text, const std::string& fileName, const Progress& progress,
                       std::string_view pictures) {
    SceneParser parser(text, fileName);
    parser.takePictures(pictures);
    NameUses uses;
    parser.lookForMistakes(uses);
    while (parser.next()) {
        if (progress) progress(kShareOfParsing * parser.share());
    }
    return parser.take();
}

}  // namespace slicecast
