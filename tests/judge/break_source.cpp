// Breaks one source of the renderer on purpose, as a row of mutations.json says: a piece of the
// file's text, white space ignored, is replaced by another.
//
//     break_source MUTATIONS FOLDER               checks that each row's text stands exactly once
//     break_source MUTATIONS FOLDER NAME OUTPUT   writes the broken copy of that row's file
//
// Exit status 0 if all is well; else standard error says which rows are wrong.

#include <rapidjson/document.h>
#include <rapidjson/error/en.h>

#include <cctype>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

std::optional<std::string> readAll(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), {});
}

// A text without its white space, and where each of its characters stood.
struct Dense {
    explicit Dense(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (std::isspace(static_cast<unsigned char>(text[i]))) continue;
            characters += text[i];
            places.push_back(i);
        }
    }
    std::string characters;
    std::vector<std::size_t> places;
};

struct Mutation {
    std::string name, file, find, replace;
};

// The broken text, or nothing unless `find` stands exactly once in it.
std::optional<std::string> broken(const std::string& text, const Mutation& mutation) {
    const Dense source(text);
    const Dense wanted(mutation.find);
    const std::size_t at = source.characters.find(wanted.characters);
    if (wanted.characters.empty() || at == std::string::npos) return std::nullopt;
    if (source.characters.find(wanted.characters, at + 1) != std::string::npos) return std::nullopt;
    const std::size_t first = source.places[at];
    const std::size_t last = source.places[at + wanted.characters.size() - 1];
    return text.substr(0, first) + mutation.replace + text.substr(last + 1);
}

bool complain(const Mutation& mutation, const char* what) {
    std::fprintf(stderr, "mutation %s: %s: %s: \"%s\"\n", mutation.name.c_str(),
                 mutation.file.c_str(), what, mutation.find.c_str());
    return false;
}

// Writes the broken file unless `output` is empty.
bool apply(const Mutation& mutation, const std::filesystem::path& folder,
           const std::filesystem::path& output) {
    const std::optional<std::string> text = readAll(folder / mutation.file);
    if (!text) return complain(mutation, "the file cannot be read");
    const std::optional<std::string> result = broken(*text, mutation);
    if (!result) return complain(mutation, "expected this text exactly once");
    if (output.empty()) return true;
    std::filesystem::create_directories(output.parent_path());
    return (std::ofstream(output, std::ios::binary) << *result).good() ||
           complain(mutation, "the broken copy cannot be written");
}

std::vector<Mutation> readMutations(const std::filesystem::path& path) {
    rapidjson::Document rows;
    rows.Parse(readAll(path).value_or("").c_str());
    if (rows.HasParseError() || !rows.IsArray()) {
        std::fprintf(stderr, "%s: expected a list of mutations: %s\n", path.c_str(),
                     rapidjson::GetParseError_En(rows.GetParseError()));
        return {};
    }
    std::vector<Mutation> mutations;
    for (const auto& row : rows.GetArray()) {
        const auto text = [&](const char* key) {
            return row.HasMember(key) && row[key].IsString() ? row[key].GetString() : "";
        };
        mutations.push_back({text("name"), text("file"), text("find"), text("replace")});
    }
    return mutations;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 5) {
        std::fprintf(stderr, "break_source: expected MUTATIONS FOLDER [NAME OUTPUT]\n");
        return 1;
    }
    const std::filesystem::path folder = argv[2];
    bool isRight = true;
    int applied = 0;
    for (const Mutation& mutation : readMutations(argv[1])) {
        if (argc == 5 && mutation.name != argv[3]) continue;
        ++applied;
        isRight = apply(mutation, folder, argc == 5 ? argv[4] : "") && isRight;
    }
    if (applied == 0) std::fprintf(stderr, "break_source: no such mutation\n");
    return isRight && applied > 0 ? 0 : 1;
}
