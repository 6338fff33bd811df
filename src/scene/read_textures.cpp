#include "base/name_index.h"
#include "scene/limits.h"
#include "scene/readers.h"

#include <cmath>

namespace slicecast {
namespace {

// A file name that works on every system and in URLs: relative, with forward slashes and without
// the special characters of URLs.
bool isPortable(std::string_view name) {
    if (name.empty() || name.front() == '/') return false;
    for (const char c : name) {
        if (static_cast<unsigned char>(c) < 0x20 ||
            std::string_view("\\:?#%*\"<>|").find(c) != std::string_view::npos) {
            return false;
        }
    }
    return true;
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
    if (!isPortable(*name)) {
        checker.add(value, {"the file name ", quoted(*name)},
                    {expected, ", with forward slashes and none of \\ : ? # % * \" < > |"});
        return std::nullopt;
    }
    if (!isPng(*name)) {
        checker.add(value, {"the file name ", quoted(*name)},
                    "a name that ends in .png; only PNG files are read");
        return std::nullopt;
    }
    return name;
}

ImageReference referTo(const Checker& checker, JsonValue value, std::string file) {
    return {std::move(file), value.pointer(), checker.source().place(value.offset())};
}

// "brick.png" or { "file": "lava.png", "frames": 8, "rate": 10 } or, held at its first frame, {
// "file": "door.png", "frames": 8 }
TextureReference readTexture(Checker& checker, JsonValue value) {
    TextureReference texture;
    if (!value.isObject()) {
        texture.image = referTo(checker, value, readFileName(checker, value).value_or(""));
        return texture;
    }
    const auto fields =
        checker.fields(value, {"file", "frames", "rate"},
                       "a PNG file's name, or an object with \"file\" and \"frames\"");
    if (!fields) return texture;
    if (const auto file = fields->require("file", "the name of a PNG file"))
        texture.image = referTo(checker, *file, readFileName(checker, *file).value_or(""));
    constexpr NumberRange kFrames = {2.0, kMaxFrames, false,
                                     "a whole number of frames, from 2 to 64"};
    constexpr NumberRange kRate = {0.0, kMaxFrameRate, true,
                                   "a number of frames per second, above 0 and at most 120"};
    if (const auto frames = fields->require("frames", kFrames.words)) {
        const double count = checker.number(*frames, kFrames).value_or(2.0);
        if (count != std::floor(count)) checker.refuse(*frames, kFrames.words);
        texture.frames = static_cast<int>(count);
    }
    if (const auto rate = fields->find("rate"))
        texture.rate = checker.number(*rate, kRate).value_or(1.0);
    return texture;
}

namespace {

// Either "#c03020", or what readTexture takes.
TextureReference readTextureOrColour(Checker& checker, JsonValue value) {
    if (!value.isText() || value.text().substr(0, 1) != "#") return readTexture(checker, value);
    TextureReference texture;
    texture.image = referTo(checker, value, std::string(value.text()));
    texture.colour = checker.colour(value).value_or(Colour{});
    return texture;
}

}  // namespace

void readTextures(Reading& reading, JsonValue value) {
    Checker& checker = reading.checker;
    if (!value.isObject()) {
        checker.refuse(value, "the textures: an object with a PNG file or a colour for each name");
        reading.textures.takeAny();
        return;
    }
    if (value.count() > static_cast<std::size_t>(kMaxTextures)) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "texture"},
                    {"at most ", kMaxTextures});
        reading.textures.takeAny();
        return;
    }
    NameIndex ids;
    std::vector<std::string> sheets;  // the names in the index; reserved, so that none moves
    sheets.reserve(value.count());
    for (const JsonValue member : value) {
        if (member.key().empty() || countCharacters(member.key()) > kMaxNameLength) {
            checker.addAtKey(member, {"the name ", quoted(member.key())},
                             {"a name of 1 to ", kMaxNameLength, " characters"});
        }
        // The name of a faulty texture still counts as known.
        TextureReference reference = readTextureOrColour(checker, member);
        const auto next = static_cast<std::uint32_t>(reading.description.textures.size());
        const std::uint32_t id =
            ids.add(sheets.emplace_back(words(reference.image.file, "\n", reference.frames, " ",
                                              Shortest{reference.rate})),
                    next);
        if (id == next) {
            Texture texture;
            texture.name = std::string(member.key());
            reading.description.world.textures.push_back(std::move(texture));
            reading.description.textures.push_back(std::move(reference));
        }
        reading.textures.add(member.key(), static_cast<TextureId>(id));
    }
}

}  // namespace slicecast
