#include "scene_maker.h"

#include "scene_scaffold.h"

#include <rapidjson/pointer.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>

namespace slicecast {

namespace {

using Json = rapidjson::Value;

constexpr std::size_t kMostNames = 100;  // characters: a text of at most so many is a name
constexpr std::size_t kMostRows = 4096;  // an array of texts of at most so many is rows of tiles

std::string written(const Json& value) {
    rapidjson::StringBuffer buffer;
    rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
    value.Accept(writer);
    return {buffer.GetString(), buffer.GetSize()};
}

const Json* member(const Json& object, const char* name) {
    if (!object.IsObject()) return nullptr;
    const auto found = object.FindMember(name);
    return found == object.MemberEnd() ? nullptr : &found->value;
}
Json* member(Json& object, const char* name) {
    return const_cast<Json*>(member(std::as_const(object), name));
}

std::span<Json::Member> membersOf(Json& object) {
    if (object.ObjectEmpty()) return {};
    return {&*object.MemberBegin(), object.MemberCount()};
}

double numberIn(const Json& schema, const char* name, double otherwise) {
    const Json* const number = member(schema, name);
    return number != nullptr && number->IsNumber() ? number->GetDouble() : otherwise;
}

std::string_view textOf(const Json* value) {
    return value != nullptr && value->IsString()
               ? std::string_view(value->GetString(), value->GetStringLength())
               : std::string_view();
}

bool isListed(const Json* list, const Json& text) {
    if (list == nullptr) return false;
    for (const Json& entry : list->GetArray())
        if (entry == text) return true;
    return false;
}

bool fits(const Json& value, const Json& schema) {
    if (const Json* const choices = member(schema, "enum")) return isListed(choices, value);
    const std::string_view type = textOf(member(schema, "type"));
    if (type == "string") return value.IsString();
    if (type == "boolean") return value.IsBool();
    if (type == "number") return value.IsNumber();
    if (type == "integer") return value.IsNumber();
    if (type == "array") return value.IsArray();
    if (type != "object" || !value.IsObject()) return false;
    if (const Json* const required = member(schema, "required"))
        for (const Json& name : required->GetArray())
            if (!value.HasMember(name)) return false;
    const Json* const known = member(schema, "properties");
    const Json* const others = member(schema, "additionalProperties");
    if (others != nullptr && others->IsObject()) return true;
    for (const auto& each : value.GetObject())
        if (known == nullptr || !known->HasMember(each.name)) return false;
    return true;
}

bool areRows(const Json& schema) {
    const Json* const items = member(schema, "items");
    return items != nullptr && textOf(member(*items, "type")) == "string" &&
           numberIn(*items, "maxLength", 0.0) >= kMostRows;
}

std::u32string fromUtf8(std::string_view text) {
    std::u32string all;
    for (const char each : text) {
        const auto byte = static_cast<unsigned char>(each);
        if ((byte & 0xc0) != 0x80)
            all += static_cast<char32_t>(byte < 0x80   ? byte
                                         : byte < 0xe0 ? byte & 0x1f
                                         : byte < 0xf0 ? byte & 0x0f
                                                       : byte & 0x07);
        else if (!all.empty())
            all.back() = all.back() << 6 | (byte & 0x3f);
    }
    return all;
}

std::string toUtf8(std::u32string_view text) {
    std::string all;
    for (const char32_t c : text) {
        const auto last = [&](int shift) { all += static_cast<char>(0x80 | (c >> shift & 0x3f)); };
        if (c < 0x80) {
            all += static_cast<char>(c);
        } else if (c < 0x800) {
            all += static_cast<char>(0xc0 | c >> 6);
            last(0);
        } else if (c < 0x10000) {
            all += static_cast<char>(0xe0 | c >> 12);
            last(6), last(0);
        } else {
            all += static_cast<char>(0xf0 | c >> 18);
            last(12), last(6), last(0);
        }
    }
    return all;
}

}  // namespace

// ---- The schema

SceneMaker::SceneMaker(std::string_view schema, ScenePictures pictures, int widest)
    : pictures_(std::move(pictures)), widest_(widest) {
    schema_.Parse(schema.data(), schema.size());
    if (schema_.HasParseError() || !schema_.IsObject()) std::abort();
    addKeys(schema_, "");
}

void SceneMaker::addWays(const Json& schema, std::string about, std::vector<Way>& ways) const {
    about += std::string(textOf(member(schema, "description"))) + " ";
    if (const Json* const reference = member(schema, "$ref")) {
        const std::string place(textOf(reference).substr(1));
        const Json* const meant = rapidjson::Pointer(place.c_str()).Get(schema_);
        if (meant == nullptr) std::abort();
        return addWays(*meant, about, ways);
    }
    // One that has a type, too, is that type under a condition.
    for (const char* const name : {"allOf", "anyOf", "oneOf"}) {
        const Json* const parts = member(schema, name);
        if (parts == nullptr || schema.HasMember("type")) continue;
        for (const Json& part : parts->GetArray()) addWays(part, about, ways);
        return;
    }
    ways.push_back({&schema, about});
}

std::vector<SceneMaker::Way> SceneMaker::waysOf(const Json& schema,
                                                const std::string& about) const {
    std::vector<Way> ways;
    addWays(schema, about, ways);
    return ways;
}

SceneMaker::Way SceneMaker::wayOf(const Json& value, const Json& schema,
                                  const std::string& about) const {
    for (const Way& way : waysOf(schema, about))
        if (fits(value, *way.schema)) return way;
    return {};
}

const SceneMaker::Json* SceneMaker::memberSchema(const Json& object, const Json& name) const {
    if (const Json* const known = member(object, "properties"))
        if (const auto found = known->FindMember(name); found != known->MemberEnd())
            return &found->value;
    const Json* const others = member(object, "additionalProperties");
    return others != nullptr && others->IsObject() ? others : nullptr;
}

// Numbers all keys that a scene may have, and returns how many stand within the schema.
int SceneMaker::addKeys(const Json& schema, const std::string& name) {
    if (const auto known = weights_.find(&schema); known != weights_.end()) return known->second;
    int sum = 1;
    for (const Way& way : waysOf(schema)) {
        if (const Json* const known = member(*way.schema, "properties"))
            for (const auto& each : known->GetObject()) {
                std::string keyName = name.empty() ? "" : name + ".";
                keyName += each.name.GetString();
                keys_.try_emplace(&each.value, Key{keyName, 0});
                sum += addKeys(each.value, keyName);
            }
        for (const char* const part : {"additionalProperties", "items"})
            if (const Json* const inner = member(*way.schema, part))
                if (inner->IsObject()) sum += addKeys(*inner, name);
    }
    return weights_[&schema] = sum;
}

int SceneMaker::weightOf(const Json& schema) const {
    const auto known = weights_.find(&schema);
    return known == weights_.end() ? 1 : known->second;
}

void SceneMaker::count(const std::string& text) {
    rapidjson::Document scene;
    scene.Parse(text.data(), text.size());
    if (!scene.HasParseError()) countIn(scene, schema_);
}

void SceneMaker::countIn(const Json& value, const Json& schema) {
    const Way way = wayOf(value, schema);
    if (way.schema == nullptr) return;
    if (value.IsObject()) {
        for (const auto& each : value.GetObject()) {
            const Json* const inner = memberSchema(*way.schema, each.name);
            if (inner == nullptr) continue;
            if (const auto key = keys_.find(inner); key != keys_.end()) ++key->second.met;
            countIn(each.value, *inner);
        }
    } else if (value.IsArray() && way.schema->HasMember("items") && !areRows(*way.schema)) {
        for (const Json& each : value.GetArray()) countIn(each, (*way.schema)["items"]);
    }
}

std::vector<std::string> SceneMaker::neverMet() const {
    std::vector<std::string> names;
    for (const auto& [schema, key] : keys_)
        if (key.met == 0) names.push_back(key.name);
    std::sort(names.begin(), names.end());
    return names;
}

// ---- Changes

// One change of a scene: goes down from the whole to some part, and changes that.
class SceneMaker::Change {
public:
    Change(const SceneMaker& maker, rapidjson::Document& scene, Random& random)
        : maker_(maker), scene_(scene), memory_(scene.GetAllocator()), random_(random) {
        collectNames();
    }

    void apply() {
        if (!random_.oneIn(3) || !addNeverMet()) change(scene_, maker_.schema_, "");
    }

private:
    // -- Keys that no counted scene had

    // An object that may have such a key, and has none yet.
    struct Place {
        Json* object;
        const Json* name;
        const Json* schema;
        std::string about;
    };

    bool addNeverMet() {
        std::vector<Place> places;
        findPlaces(scene_, maker_.schema_, "", places);
        if (places.empty()) return false;
        const Place& place =
            places[static_cast<std::size_t>(random_.below(static_cast<int>(places.size())))];
        set(*place.object, *place.name, made(*place.schema, place.about));
        return true;
    }

    void findPlaces(Json& value, const Json& schema, const std::string& about,
                    std::vector<Place>& places) {
        const Way way = maker_.wayOf(value, schema, about);
        if (way.schema == nullptr) return;
        if (value.IsObject()) {
            enter(value);
            if (const Json* const known = member(*way.schema, "properties"))
                for (const auto& each : known->GetObject())
                    if (!value.HasMember(each.name) && maker_.keys_.at(&each.value).met == 0)
                        places.push_back({&value, &each.name, &each.value, way.about});
            for (Json::Member& each : membersOf(value))
                if (const Json* const inner = maker_.memberSchema(*way.schema, each.name))
                    findPlaces(each.value, *inner, way.about, places);
        } else if (value.IsArray() && way.schema->HasMember("items") && !areRows(*way.schema)) {
            for (Json& each : value.GetArray())
                findPlaces(each, (*way.schema)["items"], way.about, places);
        }
    }

    // -- What the scene has

    void collectNames() {
        for (Json::Member& each : membersOf(scene_)) {
            const std::string key = each.name.GetString();
            if (each.value.IsObject() && key.back() == 's')
                for (const Json::Member& one : membersOf(each.value))
                    names_[key.substr(0, key.size() - 1)].push_back(one.name.GetString());
        }
        for (const char* const kind : {"find", "kind"}) names_[kind] = {"gold", "key"};
        const Json* const maps = member(scene_, "maps");
        if (maps == nullptr || !maps->IsArray()) return;
        for (const Json& map : maps->GetArray()) {
            if (const Json* const places = member(map, "places"); places && places->IsObject())
                for (const auto& each : places->GetObject())
                    names_["named place"].push_back(each.name.GetString());
            const std::string_view name = textOf(member(map, "name"));
            names_["map"].emplace_back(name);
        }
    }

    // Of a level, which is rows or may have some over what fills it.
    static const Json& rowsOf(const Json& level) {
        const Json* const rows = member(level, "rows");
        return rows != nullptr ? *rows : level;
    }

    // Notes the size of a map and the characters of a legend that hold within an object.
    void enter(const Json& object) {
        if (const Json* const levels = member(object, "levels")) {
            if (levels->IsArray())
                for (const Json& level : levels->GetArray()) {
                    const Json& rows = rowsOf(level);
                    if (rows.IsArray() && !rows.Empty() && rows[0].IsString()) {
                        depth_ = static_cast<int>(rows.Size());
                        width_ = static_cast<int>(fromUtf8(textOf(rows.Begin())).size());
                        levels_ = static_cast<int>(levels->Size());
                        break;
                    }
                }
            const Json* const size = member(object, "size");
            if (size != nullptr && size->IsArray() && size->Size() == 2 && (*size)[0].IsInt() &&
                (*size)[1].IsInt()) {
                width_ = (*size)[0].GetInt();
                depth_ = (*size)[1].GetInt();
            }
        } else if (object.HasMember("texture") || object.HasMember("rows") || &object == &scene_) {
            characters_.clear();
        }
        const Json* const legend = member(object, "legend");
        if (legend != nullptr && legend->IsObject())
            for (const auto& each : legend->GetObject())
                characters_ += fromUtf8(textOf(&each.name));
    }

    // -- Down to what is changed

    void change(Json& value, const Json& schema, const std::string& about) {
        const Way way = maker_.wayOf(value, schema, about);
        if (way.schema == nullptr || (!value.IsObject() && !value.IsArray())) {
            value = made(schema, about);
        } else if (value.IsObject()) {
            enter(value);
            if (value.HasMember("levels") && value.HasMember("floor") && random_.oneIn(12))
                return resize(value);
            Json* const inner =
                value.ObjectEmpty() || random_.oneIn(3) ? nullptr : heavyMember(value, *way.schema);
            if (inner == nullptr) return changeObject(value, way);
            change(*inner, *schemaOfHeavy_, way.about);
        } else if (areRows(*way.schema)) {
            changeRows(value);
        } else if (value.Empty() || random_.oneIn(3) || !way.schema->HasMember("items")) {
            changeArray(value, way);
        } else {
            change(value[static_cast<unsigned>(random_.below(static_cast<int>(value.Size())))],
                   (*way.schema)["items"], way.about);
        }
    }

    // A member by chance; those within which more keys may stand come more often.
    Json* heavyMember(Json& object, const Json& schema) {
        int sum = 0;
        Json* chosen = nullptr;
        for (Json::Member& each : membersOf(object)) {
            const Json* const inner = maker_.memberSchema(schema, each.name);
            if (inner == nullptr) continue;
            const int weight = maker_.weightOf(*inner);
            sum += weight;
            if (random_.below(sum) >= weight) continue;
            chosen = &each.value;
            schemaOfHeavy_ = inner;
        }
        return chosen;
    }

    void changeObject(Json& object, const Way& way) {
        const Json* const known = member(*way.schema, "properties");
        if (known == nullptr) return changeNamed(object, way);
        if (!object.ObjectEmpty() && random_.oneIn(5)) {
            const auto gone =
                object.MemberBegin() + random_.below(static_cast<int>(object.MemberCount()));
            if (!isListed(member(*way.schema, "required"), gone->name)) object.EraseMember(gone);
            return;
        }
        // Some keys together, as some need others. Of three, that which was met least; or any.
        for (int left = random_.between(1, 4); left > 0; --left) {
            auto chosen = known->MemberEnd();
            for (int i = random_.oneIn(2) ? 3 : 1; i > 0; --i) {
                const auto next =
                    known->MemberBegin() + random_.below(static_cast<int>(known->MemberCount()));
                if (chosen == known->MemberEnd() || metOf(next->value) < metOf(chosen->value))
                    chosen = next;
            }
            const Json* const there = member(object, chosen->name.GetString());
            if (there != nullptr && random_.oneIn(2) && (there->IsObject() || there->IsArray()))
                return change(object[chosen->name], chosen->value, way.about);
            set(object, chosen->name, made(chosen->value, way.about));
        }
    }

    long metOf(const Json& schema) const {
        const auto key = maker_.keys_.find(&schema);
        return key == maker_.keys_.end() ? 0 : key->second.met;
    }

    void set(Json& object, const Json& name, Json value) {
        if (object.HasMember(name))
            object[name] = std::move(value);
        else
            object.AddMember(Json(name, memory_), value, memory_);
    }

    // Of an object whose keys are names or characters.
    void changeNamed(Json& object, const Way& way) {
        const Json& schema = (*way.schema)["additionalProperties"];
        if (isLegend(*way.schema) && !schema.HasMember("$ref") && random_.oneIn(4)) {
            // A character for every blueprint
            char32_t next = 0x4e00;
            for (const std::string& name : names_["blueprint"])
                set(object, text(toUtf8({&next, 1})), text(name)), ++next;
            return;
        }
        const bool isSingle = object.ObjectEmpty() || random_.oneIn(2);
        const int most = std::min(isSingle ? 1 : 1 << random_.below(8), mostLike(object));
        for (int i = 0; i < most; ++i) {
            Json name = newName(*way.schema, isSingle);
            if (object.ObjectEmpty() || random_.oneIn(2)) {
                set(object, name, made(schema, way.about));
            } else {
                const auto like =
                    object.MemberBegin() + random_.below(static_cast<int>(object.MemberCount()));
                Json copy(like->value, memory_);
                varyNumbers(copy, schema, way.about);
                set(object, name, std::move(copy));
            }
        }
    }

    static bool isLegend(const Json& schema) {
        const Json* const names = member(schema, "propertyNames");
        return names != nullptr && names->HasMember("pattern");
    }

    Json newName(const Json& schema, bool isShort) {
        if (!isLegend(schema)) return text("n" + std::to_string(random_.below(isShort ? 8 : 999)));
        constexpr std::string_view kCharacters = "#abcdefhijkmnopqrstuvxyzABCDEFHIJKLMNOPQRSTUV+*";
        return text(std::string(
            1, kCharacters[static_cast<std::size_t>(random_.below(int{kCharacters.size()}))]));
    }

    void changeArray(Json& array, const Way& way) {
        const int size = static_cast<int>(array.Size());
        const Json* const items = member(*way.schema, "items");
        if (size > 0 && (items == nullptr || random_.oneIn(5))) {
            // One goes, or half of all
            const auto first = array.Begin() + random_.below(size);
            array.Erase(first,
                        random_.oneIn(4) ? first + (array.End() - first + 1) / 2 : first + 1);
            return;
        }
        if (items == nullptr) return;
        const auto most = static_cast<int>(numberIn(*way.schema, "maxItems", 1e6)) - size;
        // One more, or many that are like one
        const bool isSingle = random_.oneIn(3);
        Json like = size > 0 && random_.oneIn(2)
                        ? Json(array[static_cast<unsigned>(random_.below(size))], memory_)
                        : made(*items, way.about);
        const int count = std::min({isSingle ? 1 : 1 << random_.below(12), most, mostOf(like)});
        for (int i = 0; i < count; ++i) {
            Json next(like, memory_);
            if (i > 0) varyNumbers(next, *items, way.about);
            array.PushBack(next, memory_);
        }
    }

    // How many values like this fit into a scene.
    static int mostOf(const Json& like) {
        return static_cast<int>(kMostSceneText * 3 / 4 / (written(like).size() + 1)) + 1;
    }
    static int mostLike(const Json& object) {
        return object.ObjectEmpty() ? 1 : mostOf(object.MemberBegin()->value);
    }

    // Gives half of the numbers and names within a value others.
    void varyNumbers(Json& value, const Json& schema, const std::string& about) {
        const Way way = maker_.wayOf(value, schema, about);
        if (way.schema == nullptr) return;
        if (value.IsObject()) {
            for (Json::Member& each : membersOf(value))
                if (const Json* const inner = maker_.memberSchema(*way.schema, each.name))
                    varyNumbers(each.value, *inner, way.about);
        } else if (value.IsArray()) {
            if (const Json* const items = member(*way.schema, "items");
                items != nullptr && !areRows(*way.schema))
                for (Json& each : value.GetArray()) varyNumbers(each, *items, way.about);
        } else if (!value.IsBool() && random_.oneIn(2) && !isText(value, *way.schema)) {
            value = made(*way.schema, way.about);
        }
    }
    static bool isText(const Json& value, const Json& schema) {
        return value.IsString() && numberIn(schema, "maxLength", 1e6) > kMostNames;
    }

    // -- Rows of characters

    char32_t character() {
        if (characters_.empty() || random_.oneIn(5)) return random_.oneIn(5) ? U' ' : U'.';
        return characters_[static_cast<std::size_t>(
            random_.below(static_cast<int>(characters_.size())))];
    }

    // Fills a part of it, densely or thinly, with one character or with all.
    void changeRows(Json& rows) {
        if (rows.Empty() || random_.oneIn(20)) {
            rows = emptyRows();
            if (random_.oneIn(8)) return;
        }
        const int depth = static_cast<int>(rows.Size());
        const int first = random_.oneIn(3) ? 0 : random_.below(depth);
        const int last = random_.oneIn(3) ? depth : random_.between(first, depth);
        const int width = std::max(width_, 1);
        const int left = random_.oneIn(3) ? 0 : random_.below(width);
        const int right = random_.oneIn(3) ? width : random_.between(left, width);
        const int step = 1 + random_.below(3) * random_.below(3);
        const int rarity = 1 << random_.below(6) * random_.below(2);
        const bool isMixed = random_.oneIn(3);
        char32_t one = character();
        for (int y = first; y < last; y += step) {
            Json& row = rows[static_cast<unsigned>(y)];
            if (!row.IsString()) continue;
            std::u32string tiles = fromUtf8(textOf(&row));
            for (int x = left; x < std::min(right, static_cast<int>(tiles.size())); x += step) {
                if (!random_.oneIn(rarity)) continue;
                if (isMixed) one = character();
                tiles[static_cast<std::size_t>(x)] = one;
            }
            row = text(toUtf8(tiles));
        }
    }

    Json emptyRows() {
        Json rows(rapidjson::kArrayType);
        const std::string row(static_cast<std::size_t>(std::max(width_, 1)), '.');
        for (int y = 0; y < std::max(depth_, 1); ++y) rows.PushBack(text(row), memory_);
        return rows;
    }

    // Makes a map larger, by repeating it, or smaller.
    void resize(Json& map) {
        const int width = random_.between(1, std::min(maker_.widest_, 1 + 2 * width_));
        const int depth = random_.between(1, std::min(maker_.widest_, 1 + 2 * depth_));
        resizeLevels(map["levels"], width, depth);
        Json size(rapidjson::kArrayType);
        size.PushBack(width, memory_).PushBack(depth, memory_);
        if (map.HasMember("size")) map["size"] = size;
        for (const char* const plane : {"floor", "ceiling"})
            if (Json* const whole = member(map, plane); whole != nullptr && whole->IsObject())
                if (Json* const tiles = member(*whole, "tiles")) resizeRows(*tiles, width, depth);
        if (Json* const objects = member(map, "objectRows"); objects != nullptr)
            if (Json* const rows = member(*objects, "rows")) resizeRows(*rows, width, depth);
    }
    void resizeLevels(Json& levels, int width, int depth) {
        if (!levels.IsArray()) return;
        for (Json& level : levels.GetArray()) {
            if (Json* const repeated = member(level, "levels"))
                resizeLevels(*repeated, width, depth);
            resizeRows(const_cast<Json&>(rowsOf(level)), width, depth);
        }
    }
    void resizeRows(Json& rows, int width, int depth) {
        if (!rows.IsArray() || rows.Empty()) return;
        Json all(rapidjson::kArrayType);
        for (int y = 0; y < depth; ++y) {
            const std::u32string old =
                fromUtf8(textOf(&rows[static_cast<unsigned>(y) % rows.Size()]));
            std::u32string tiles(static_cast<std::size_t>(width), U'.');
            for (std::size_t x = 0; x < tiles.size() && !old.empty(); ++x)
                tiles[x] = old[x % old.size()];
            all.PushBack(text(toUtf8(tiles)), memory_);
        }
        rows = all;
    }

    // -- New values

    Json text(const std::string& words) {
        return Json(words.data(), static_cast<rapidjson::SizeType>(words.size()), memory_);
    }

    Json made(const Json& schema, const std::string& about) {
        const std::vector<Way> ways = maker_.waysOf(schema, about);
        const Way& way =
            ways[static_cast<std::size_t>(random_.below(static_cast<int>(ways.size())))];
        const Json& one = *way.schema;
        if (const Json* const choices = member(one, "enum"))
            return Json(
                (*choices)[static_cast<unsigned>(random_.below(static_cast<int>(choices->Size())))],
                memory_);
        if (textOf(member(one, "title")) == "Data") return madeData(3);
        const std::string_view type = textOf(member(one, "type"));
        if (type == "boolean") return Json(random_.oneIn(2));
        if (type == "number" || type == "integer") return madeNumber(one, type == "integer");
        if (textOf(member(one, "title")) == "Character") {
            const char32_t sign = character();
            return text(toUtf8({&sign, 1}));
        }
        if (type == "string") return madeText(one, way.about);
        if (type == "array") return madeArray(one, way.about);
        if (type == "object") return madeObject(one, way.about);
        return Json();
    }

    // Any JSON, with objects and arrays at most so deep.
    Json madeData(int depth) {
        switch (random_.below(depth > 0 ? 6 : 4)) {
            case 0:
                return Json(random_.unit());
            case 1:
                return text("levels");
            case 2:
                return Json(random_.oneIn(2));
            case 3:
                return Json();
            case 4: {
                Json array(rapidjson::kArrayType);
                for (int i = random_.below(3); i >= 0; --i)
                    array.PushBack(madeData(depth - 1), memory_);
                return array;
            }
            default: {
                Json object(rapidjson::kObjectType);
                for (const char* const key : {"comment", "x", ""})
                    if (random_.oneIn(2)) set(object, text(key), madeData(depth - 1));
                return object;
            }
        }
    }

    Json madeNumber(const Json& schema, bool isWhole) {
        const double least = numberIn(schema, "minimum", numberIn(schema, "exclusiveMinimum", 0.0));
        const double most = numberIn(schema, "maximum", 1e6);
        double value = least;
        switch (random_.below(8)) {
            case 0:
                break;  // the least, or next to it
            case 1:
                value = most;
                break;
            case 2:
                value = numberIn(schema, "default", random_.between(least, most));
                break;
            default:
                // Of any size
                value = random_.between(least, most);
                if (least < 0.0) value = random_.unit() < 0.5 ? most : least;
                value =
                    (least < 0.0 ? 0.0 : least) + (value - (least < 0.0 ? 0.0 : least)) /
                                                      static_cast<double>(1 << random_.below(13));
        }
        // Places in the map
        const bool isTile = most == 4095.0 || most == 4096.0;
        if (isTile && !random_.oneIn(12)) value = random_.unit() * std::max(width_, 1);
        if (isWhole && most == 32.0 && random_.oneIn(2))
            value = random_.below(std::max(levels_, 1));
        if (isWhole) return Json(static_cast<std::int64_t>(std::clamp(value, least, most)));
        if (random_.oneIn(2)) value = std::floor(value * 16.0) / 16.0;
        if (schema.HasMember("exclusiveMinimum") && value <= least)
            value =
                least + std::min(1.0, most - least) / static_cast<double>(1 << random_.below(20));
        return Json(std::clamp(value, least, most));
    }

    Json madeText(const Json& schema, const std::string& about) {
        const std::string_view pattern = textOf(member(schema, "pattern"));
        const ScenePictures& pictures = maker_.pictures_;
        if (pattern.find("png") != std::string_view::npos) {
            const std::array files = {&pictures.wall,   &pictures.seeThrough, &pictures.sheet,
                                      &pictures.sprite, &pictures.walker,     &pictures.panorama};
            return text(*files[static_cast<std::size_t>(random_.below(int{files.size()}))]);
        }
        if (pattern.starts_with("^#")) {
            std::string colour = "#";
            for (int i = 0; i < 3; ++i)
                colour +=
                    std::array{"00", "ff", "40", "9c"}[static_cast<std::size_t>(random_.below(4))];
            return text(colour);
        }
        const auto most = static_cast<std::size_t>(numberIn(schema, "maxLength", 1000.0));
        if (most <= kMostNames) return text(madeName(about));
        constexpr std::string_view kWords = "A long way — ein Würfel, \"quoted\" \\ and 🧱. ";
        std::string words = "Text";
        for (int i = random_.oneIn(4) ? random_.below(8) : 0; i > 0; --i) words += kWords;
        return text(words.size() <= most ? words : "T");
    }

    // A name of what the schema's words speak of: a texture, a sprite, a map...
    std::string madeName(const std::string& about) {
        std::string words;
        for (const char c : about) words += static_cast<char>(std::tolower(c));
        std::vector<const std::vector<std::string>*> meant;
        for (const auto& [kind, names] : names_)
            if (!names.empty() && words.find(kind) != std::string::npos) meant.push_back(&names);
        if (meant.empty() || random_.oneIn(16)) return "n" + std::to_string(random_.below(8));
        const auto& names =
            *meant[static_cast<std::size_t>(random_.below(static_cast<int>(meant.size())))];
        return names[static_cast<std::size_t>(random_.below(static_cast<int>(names.size())))];
    }

    Json madeArray(const Json& schema, const std::string& about) {
        if (areRows(schema)) {
            Json rows = emptyRows();
            changeRows(rows);
            return rows;
        }
        Json array(rapidjson::kArrayType);
        const Json* const items = member(schema, "items");
        if (items == nullptr) return array;
        const int least = static_cast<int>(numberIn(schema, "minItems", 0.0));
        const int most = static_cast<int>(numberIn(schema, "maxItems", 1e6));
        const int count = std::clamp(1 + random_.below(3), least, most);
        for (int i = 0; i < count; ++i) array.PushBack(made(*items, about), memory_);
        return array;
    }

    // The keys that one of the ways to write an object needs, by chance, if it has ways.
    const Json* alternative(const Json& schema) {
        const auto ways = alternatives(schema);
        return ways[static_cast<std::size_t>(random_.below(int{ways.size()}))];
    }
    static bool isAlternative(const Json& schema, const Json& name) {
        const auto ways = alternatives(schema);
        return std::any_of(ways.begin(), ways.end(),
                           [&](const Json* way) { return isListed(way, name); });
    }
    static std::array<const Json*, 2> alternatives(const Json& schema) {
        const Json* const one = member(schema, "if");
        const Json* const needed = one != nullptr ? member(*one, "required") : nullptr;
        const Json* const other = member(schema, "else");
        if (needed == nullptr || other == nullptr) return {};
        return {needed, member(*other, "required")};
    }

    Json madeObject(const Json& schema, const std::string& about) {
        Json object(rapidjson::kObjectType);
        if (const Json* const known = member(schema, "properties")) {
            const Json* const required = member(schema, "required");
            const Json* const chosen = alternative(schema);
            const int rarity = 2 + random_.below(6);
            for (const auto& each : known->GetObject()) {
                if (isListed(chosen, each.name)) set(object, each.name, made(each.value, about));
                if (isAlternative(schema, each.name)) continue;
                const bool isNew = metOf(each.value) == 0 && random_.oneIn(2);
                if (isNew || isListed(required, each.name) || random_.oneIn(rarity))
                    set(object, each.name, made(each.value, about));
            }
            return object;
        }
        if (const Json* const others = member(schema, "additionalProperties"))
            for (int i = random_.between(1, 3); i > 0 && others->IsObject(); --i)
                set(object, newName(schema, true), made(*others, about));
        return object;
    }

    const SceneMaker& maker_;
    rapidjson::Document& scene_;
    rapidjson::Document::AllocatorType& memory_;
    Random& random_;
    std::map<std::string, std::vector<std::string>> names_;  // by what they name, as "texture"
    std::u32string characters_;                              // of the legends that hold
    int width_ = 1;                                          // tiles of the map
    int depth_ = 1;
    int levels_ = 1;
    const Json* schemaOfHeavy_ = nullptr;
};

std::string SceneMaker::changed(const std::string& text, Random& random) const {
    rapidjson::Document scene;
    scene.Parse(text.data(), text.size());
    if (scene.HasParseError() || !scene.IsObject()) return text;
    for (int i = 1 << random.below(4); i > 0; --i) Change(*this, scene, random).apply();
    std::string next = written(scene);
    return next.size() <= kMostSceneText ? next : text;
}

std::string SceneMaker::fresh(Random& random) const {
    Genes genes{};
    for (std::uint8_t& gene : genes) {
        const auto bits = random.next();
        gene = bits % 4 == 0 ? static_cast<std::uint8_t>(bits >> 8) : std::uint8_t{0};
    }
    return changed(changed(sceneScaffold(genes, pictures_, widest_), random), random);
}

// ---- Mending

namespace {

using Path = std::vector<std::string>;

Path pathOf(const std::string& pointer) {
    Path path;
    const rapidjson::Pointer parsed(pointer.c_str());
    if (!parsed.IsValid()) return path;
    for (std::size_t i = 0; i < parsed.GetTokenCount(); ++i)
        path.emplace_back(parsed.GetTokens()[i].name, parsed.GetTokens()[i].length);
    return path;
}

bool isNumber(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                        [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool isBefore(const Path& a, const Path& b) {
    return std::lexicographical_compare(
        a.begin(), a.end(), b.begin(), b.end(), [](const std::string& x, const std::string& y) {
            return isNumber(x) && isNumber(y)
                       ? std::strtol(x.c_str(), nullptr, 10) < std::strtol(y.c_str(), nullptr, 10)
                       : x < y;
        });
}

Json* valueAt(Json& scene, const Path& path, std::size_t steps) {
    Json* value = &scene;
    for (std::size_t i = 0; i < steps; ++i) {
        if (value->IsArray()) {
            const auto index = static_cast<rapidjson::SizeType>(
                isNumber(path[i]) ? std::strtoul(path[i].c_str(), nullptr, 10) : ~0u);
            if (index >= value->Size()) return nullptr;
            value = &(*value)[index];
        } else {
            value = member(*value, path[i].c_str());
            if (value == nullptr) return nullptr;
        }
    }
    return value;
}

// What the fault points at becomes as before, empty or nothing. False if it stays.
bool mend(rapidjson::Document& scene, Json& before, const Path& path, const Fault& fault) {
    Json* const value = valueAt(scene, path, path.size());
    if (value == nullptr || path.empty()) return false;
    if (fault.character >= 0 && value->IsString()) {
        std::u32string row = fromUtf8(textOf(value));
        const auto at = static_cast<std::size_t>(fault.character);
        if (at < row.size() && row[at] != U'.') {
            row[at] = U'.';
            const std::string text = toUtf8(row);
            value->SetString(text.data(), static_cast<rapidjson::SizeType>(text.size()),
                             scene.GetAllocator());
            return true;
        }
    }
    const Json* const old = valueAt(before, path, path.size());
    if (old != nullptr && *old != *value) {
        *value = Json(*old, scene.GetAllocator());
        return true;
    }
    Json* const parent = valueAt(scene, path, path.size() - 1);
    if (parent->IsArray())
        parent->Erase(value);
    else
        parent->EraseMember(path.back().c_str());
    return true;
}

}  // namespace

std::string SceneMaker::mended(std::string text, const std::string& before,
                               const FaultsOf& faultsOf) const {
    constexpr int kRounds = 8;
    rapidjson::Document old;
    old.Parse(before.data(), before.size());
    if (old.HasParseError()) old.SetObject();
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<Fault> faults = faultsOf(text);
        if (faults.empty()) return text;
        rapidjson::Document scene;
        scene.Parse(text.data(), text.size());
        if (scene.HasParseError()) return "";

        // From the end, so that the places of the others stay
        std::vector<std::pair<Path, const Fault*>> places;
        places.reserve(faults.size());
        for (const Fault& fault : faults) places.emplace_back(pathOf(fault.pointer), &fault);
        std::stable_sort(places.begin(), places.end(),
                         [](const auto& a, const auto& b) { return isBefore(b.first, a.first); });
        bool isMended = false;
        Path last;
        for (const auto& [path, fault] : places) {
            if (!last.empty() && path == last && fault->character < 0) continue;
            isMended |= mend(scene, old, path, *fault);
            last = path;
        }
        if (!isMended) return "";
        text = written(scene);
        if (round == kRounds / 2) old.SetObject();  // as before did not help
    }
    return "";
}

}  // namespace slicecast
