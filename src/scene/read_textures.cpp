#include "base/later_text.h"
#include "base/name_index.h"
#include "scene/limits.h"
#include "scene/readers.h"
#include "world/material.h"
#include "world/variants.h"

#include <cmath>

namespace slicecast {
namespace {

// What keeps a file name from working on every system and as a relative URL; empty if nothing does.
// A URL loses a blank at its beginning, and " //host/x.png" would be on another host.
std::string_view whyNotPortable(std::string_view name) {
    if (name.substr(0, 1) == "/") return ", without a slash at its beginning";
    if (name.substr(0, 1) == " ") return ", without a blank at its beginning";
    char before = 0;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        // In UTF-8 the control characters from U+0080 to U+009F begin with this byte.
        const bool isLate = static_cast<unsigned char>(before) == 0xc2 && byte < 0xa0;
        if (byte < 0x20 || byte == 0x7f || isLate) return ", without control characters";
        if (std::string_view("\\:?#%*\"<>|").find(c) != std::string_view::npos)
            return ", with forward slashes and none of \\ : ? # % * \" < > |";
        before = c;
    }
    if (name.find("//") != std::string_view::npos) return ", with single slashes";
    return {};
}

bool isPng(std::string_view name) {
    if (name.size() < 5) return false;
    const std::string_view ending = name.substr(name.size() - 4);
    return ending == ".png" || ending == ".PNG";
}

}  // namespace

std::optional<std::string> readFileName(Checker& checker, JsonValue value) {
    const std::string expected = "the name of a PNG file, relative to the scene's folder";
    std::optional<std::string> name = checker.text(value, kMaxPathLength, expected);
    if (!name) return std::nullopt;
    if (const std::string_view why = whyNotPortable(*name); !why.empty()) {
        checker.add(value, {"the file name ", quoted(*name)}, {expected, why});
        return std::nullopt;
    }
    if (!isPng(*name)) {
        checker.add(value, {"the file name ", quoted(*name)},
                    "a name that ends in .png; only PNG files are read"_later);
        return std::nullopt;
    }
    return name;
}

ImageReference referTo(const Checker& checker, JsonValue value, std::string file) {
    return {std::move(file), value.pointer(), checker.source().place(value.offset())};
}

// An object with a file may say more: { "file": "lava.png", "frames": 8, "rate": 10 } or, held at
// its first frame, { "file": "door.png", "frames": 8 } or, of a texture, { "file": "oak.png",
// "material": "wood" } or { "file": "brick.png", "variants": ["mossy"] }.
TextureReference readPicture(Checker& checker, JsonValue value, bool isTexture) {
    const std::size_t faultsBefore = checker.count();
    TextureReference picture;
    std::optional<Material> material;
    if (isTexture && value.isText() && value.text().substr(0, 1) == "#") {
        picture.image = referTo(checker, value, std::string(value.text()));
        picture.colour = checker.colour(value).value_or(Colour{});
    } else if (!value.isObject()) {
        picture.image = referTo(checker, value, readFileName(checker, value).value_or(""));
    } else {
        std::vector<std::string_view> keys = {"file", "frames", "rate", "material", "variants"};
        if (!isTexture) {
            keys.resize(3);
            keys.emplace_back("views");
        }
        const auto fields = checker.fields(
            value, keys, "a PNG file's name, or an object with \"file\" and \"frames\""_onFault);
        if (!fields) return picture;
        if (const auto file = fields->require("file", "the name of a PNG file"))
            picture.image = referTo(checker, *file, readFileName(checker, *file).value_or(""));
        static_assert(kSpriteViews == 4, "as the words say");
        constexpr NumberRange kAllViews = {4.0, 4.0, false,
                                           "4: rows for the front, right, back and left"};
        constexpr NumberRange kFrames = {2.0, kMaxFrames, false,
                                         "a whole number of frames, from 2 to 64"};
        constexpr NumberRange kRate = {0.0, kMaxFrameRate, true,
                                       "a number of frames per second, above 0 and at most 120"};
        const auto rate = fields->find("rate");
        const bool hasMaterial = isTexture && fields->find("material");
        if (hasMaterial) material = fields->choice("material", kMaterialNames, Material::stone);
        const auto views = isTexture ? FoundValue{} : fields->find("views");
        if (views && checker.number(*views, kAllViews)) picture.views = kSpriteViews;
        const bool isSheet =
            rate || !(hasMaterial || views || (isTexture && fields->find("variants")));
        if (const auto frames =
                isSheet ? fields->require("frames", kFrames.words) : fields->find("frames")) {
            const double count = checker.number(*frames, kFrames).value_or(2.0);
            if (count != std::floor(count)) checker.refuse(*frames, kFrames.words);
            picture.frames = static_cast<int>(count);
        }
        if (rate) picture.rate = checker.number(*rate, kRate).value_or(1.0);
    }
    // The names tell it else: the texture's, then the file's.
    if (!material) material = materialOfName(value.key());
    if (!material) material = materialOfName(picture.image.file);
    picture.material = material.value_or(Material::stone);
    if (checker.count() != faultsBefore) picture.image.file.clear();  // it is not looked at
    return picture;
}

namespace {

FoundValue variantsOf(JsonValue texture) {
    return texture.isObject() ? texture.find("variants") : FoundValue{};
}

// "variants" of a texture: names of textures that take its place here and there.
void readVariants(Reading& reading, JsonValue value, TextureId id) {
    Checker& checker = reading.checker;
    static_assert(kMostVariants == 8, "as the words say");
    if (!value.isArray() || value.count() == 0 || value.count() >= kMostVariants) {
        checker.refuse(value, "an array of 1 to 7 names of textures"_later);
        return;
    }
    std::vector<TextureId> pictures = {id};
    for (const JsonValue name : value)
        pictures.push_back(checker.name(name, reading.textures, "texture").value_or(id));
    reading.pictures.resize(reading.description.world.textures.size());
    reading.pictures[id] = std::move(pictures);
    reading.variants = value;
}

}  // namespace

std::optional<std::uint16_t> ShippedPictures::bring(JsonValue value) {
    const std::size_t id =
        areTextures_ ? reading_.description.textures.size() : reading_.description.sprites.size();
    const FoundValue picture = table_ ? table_->find(value.text()) : FoundValue{};
    if (!picture || id >= static_cast<std::size_t>(kMaxTextures)) return std::nullopt;
    TextureReference reference = readPicture(reading_.checker, *picture, areTextures_);
    reference.image = referTo(reading_.checker, value, words(kShippedFile, reference.image.file));
    World& world = reading_.description.world;
    if (areTextures_) {
        Texture texture;
        texture.name = std::string(value.text());
        world.textures.push_back(std::move(texture));
        reading_.description.textures.push_back(std::move(reference));
    } else {
        Sprite sprite;
        sprite.name = std::string(value.text());
        world.sprites.push_back(std::move(sprite));
        reading_.description.sprites.push_back(std::move(reference));
    }
    (areTextures_ ? reading_.textures : reading_.sprites)
        .add(value.text(), static_cast<std::uint16_t>(id));
    return static_cast<std::uint16_t>(id);
}

void ShippedPictures::list(std::vector<std::string_view>& names) const {
    if (!table_) return;
    for (const JsonValue picture : *table_) names.push_back(picture.key());
}

void readTextures(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value,
                       "the textures: an object with a PNG file or a colour for each name"_later);
        reading.textures.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxTextures)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "texture"},
                    {"at most ", kMaxTextures});
        reading.textures.takeAny();
        return;
    }
    int plain = 0;  // textures
    NameIndex ids;
    std::vector<std::string> sheets;  // the names in the index; reserved, so that none moves
    sheets.reserve(value.count());
    for (const JsonValue member : value) {
        checker.checkName(member);
        // The name of a faulty texture still counts as known.
        TextureReference reference = readPicture(checker, member, true);
        const auto next = static_cast<std::uint32_t>(reading.description.textures.size());
        const std::uint32_t id = ids.add(
            sheets.emplace_back(words(
                reference.image.file, "\n", reference.frames, " ", Shortest{reference.rate}, " ",
                static_cast<int>(reference.material), " ", variantsOf(member) ? member.key() : "")),
            next);
        if (id == next) {
            plain += reference.colour.has_value();
            if (plain > kMaxPlainTextures) {
                checker.add(member, {"more than ", kMaxPlainTextures, " colours as textures"_later},
                            {"at most ", kMaxPlainTextures, "; equal colours count as one"_later});
                reading.textures.takeAny();
                return;
            }
            Texture texture;
            texture.name = std::string(member.key());
            reading.description.world.textures.push_back(std::move(texture));
            reading.description.textures.push_back(std::move(reference));
        }
        reading.textures.add(member.key(), static_cast<TextureId>(id));
    }
    // Any texture may be a variant, also a later one.
    for (const JsonValue member : value) {
        if (const auto variants = variantsOf(member))
            readVariants(reading, *variants, reading.textures.find(member.key()).value_or(0));
    }
}

}  // namespace slicecast
