#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/material_library.h"
#include "mesh/text_cursor.h"

// MTL, the material library of OBJ files. Its colours are what a screen shows. It tells the finish in two ways. Newer
// programs write Pm (metallic) and Pr (roughness). Older ones write a mirror colour Ks and its exponent Ns: the
// exponent becomes the roughness of the microfacets that reflect alike, alpha^2 = 2 / (Ns + 2), with roughness^2 =
// alpha; without a mirror colour the surface is as rough as can be. What mirrors strongly and has next to no colour of
// its own is a metal, and the mirror's colour is its colour.

namespace partonomy {
namespace {

constexpr float strong_mirror = 0.4F, weak_color = 0.4F;  // a metal's Ks at least, and its Kd at most of that

struct Entry {
    LibraryMaterial result;
    std::optional<Color> diffuse, mirror;
    std::optional<float> exponent;
};

float read_number(TextCursor& cursor, const char* statement) {
    double value = 0;
    const char* place = cursor.position();
    if (!cursor.read(value)) cursor.fail_here(fmt::format("{} needs a number", statement));
    if (!std::isfinite(value)) cursor.fail_at(place, fmt::format("{} needs a finite number", statement));
    return static_cast<float>(std::clamp(value, -1e30, 1e30));
}

/// One or three numbers; nullopt for "spectral" and "xyz", which name colours in other ways.
std::optional<Color> read_color(TextCursor& cursor, const char* statement) {
    if (!cursor.at_line_end() && (*cursor.position() == 's' || *cursor.position() == 'x')) return std::nullopt;
    Color color = Color::Constant(read_number(cursor, statement));
    for (int i = 1; i < 3 && !cursor.at_line_end(); ++i) {
        color[i] = read_number(cursor, statement);
        if (i == 1) color[2] = color[1];
    }
    return linear_from_srgb(color);
}

/// Options with their values, then the file's name, which may have blanks.
void read_image(TextCursor& cursor, LibraryMaterial& material) {
    while (!cursor.at_line_end() && *cursor.position() == '-') {
        const std::string_view option = cursor.word();
        if (option == "-s" || option == "-o" || option == "-t") {
            TexturePoint values = option == "-s" ? TexturePoint(1, 1) : TexturePoint(0, 0);
            float value = 0;
            for (int i = 0; i < 3 && cursor.read(value); ++i)
                if (i < 2) values[i] = std::isfinite(value) ? value : 0;
            if (option == "-s") material.scale = values;
            if (option == "-o") material.offset = values;
        } else if (option == "-clamp") {
            const bool on = cursor.word() == "on";
            material.material.wrap_u = material.material.wrap_v = on ? Wrap::clamp : Wrap::repeat;
        } else {
            const int count = option == "-mm" ? 2 : 1;
            for (int i = 0; i < count; ++i) static_cast<void>(cursor.word());
        }
    }
    if (cursor.at_line_end()) cursor.fail_here("map_Kd needs the name of an image");
    const char* begin = cursor.position();
    material.image_line = cursor.line_of(begin);
    std::string_view last;
    while (!cursor.at_line_end()) last = cursor.word();
    material.image = std::string(begin, last.data() + last.size());
}

LibraryMaterial finished(Entry entry) {
    Material& material = entry.result.material;
    const bool has_mirror = entry.mirror && entry.mirror->mean() > 1e-3F;
    if (!material.roughness && (entry.mirror || entry.exponent))
        material.roughness =
            has_mirror || !entry.mirror ? std::pow(2 / (std::max(entry.exponent.value_or(0), 0.0F) + 2), 0.25F) : 1.0F;
    const bool has_image = !entry.result.image.empty();
    material.color = entry.diffuse.value_or(has_image ? Color::Ones() : Color::Constant(0.6F));
    if (!material.metallic && (entry.mirror || entry.exponent)) {
        const bool is_metal = has_mirror && !has_image && entry.mirror->mean() >= strong_mirror &&
                              material.color.mean() <= weak_color * entry.mirror->mean();
        material.metallic = is_metal ? 1.0F : 0.0F;
        if (is_metal) material.color = *entry.mirror;
    }
    // Many programs leave a black or grey Kd beside an image that should be shown as it is.
    if (has_image && material.color.maxCoeff() <= 0) material.color = Color::Ones();
    return std::move(entry.result);
}

}  // namespace

std::string LibraryMaterial::image_path() const {
    const bool is_relative = image.find(':') == std::string::npos && image.front() != '/' && image.front() != '\\';
    return is_relative ? folder + image : image;
}

std::vector<LibraryMaterial> parse_mtl(std::string_view bytes, const std::string& name) {
    TextCursor cursor(bytes, name, '#');
    std::vector<LibraryMaterial> materials;
    std::optional<Entry> entry;
    for (; cursor.find_content(); cursor.next_line()) {
        const char* place = cursor.position();
        const std::string_view statement = cursor.word();
        if (statement == "newmtl") {
            if (cursor.at_line_end()) cursor.fail_here("newmtl needs the name of the material");
            if (entry) materials.push_back(finished(*std::exchange(entry, std::nullopt)));
            const char* begin = cursor.position();
            std::string_view last;
            while (!cursor.at_line_end()) last = cursor.word();
            entry.emplace().result.material.name = std::string(begin, last.data() + last.size());
            entry->result.library = name;
            continue;
        }
        const bool is_ours = statement == "Kd" || statement == "Ks" || statement == "Ns" || statement == "Pm" ||
                             statement == "Pr" || statement == "map_Kd";
        if (!is_ours) continue;
        if (!entry) cursor.fail_at(place, fmt::format("{} stands before the first newmtl", statement));
        if (statement == "Kd") entry->diffuse = read_color(cursor, "Kd");
        if (statement == "Ks") entry->mirror = read_color(cursor, "Ks");
        if (statement == "Ns") entry->exponent = read_number(cursor, "Ns");
        if (statement == "Pm") entry->result.material.metallic = std::clamp(read_number(cursor, "Pm"), 0.0F, 1.0F);
        if (statement == "Pr") entry->result.material.roughness = std::clamp(read_number(cursor, "Pr"), 0.0F, 1.0F);
        if (statement == "map_Kd") read_image(cursor, entry->result);
    }
    if (entry) materials.push_back(finished(std::move(*entry)));
    return materials;
}

}  // namespace partonomy
