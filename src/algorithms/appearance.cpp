/* Colour and finish of a region.
 *
 * A triangle of one colour counts by its area. On others (images, colours that change from corner to corner) points
 * are spread evenly, about 4000 over a region that has no plain triangles, so that an image on two triangles is judged
 * as well as one on two million. Means are taken in OKLab, names by color_names.h. A region of which the file tells
 * less than half stays unjudged. */

#include "algorithms/appearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/catalogue.h"
#include "mesh/appearance.h"

namespace partonomy {
namespace {

constexpr double points_per_region = 4096;
constexpr double least_known = 0.5;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees_of_red = 29;

/// Gives `each(weights, share of the triangle)` for points of triangle t, whose area is this part of its region's.
template <class Each>
void for_each_point(const Appearance& appearance, std::size_t t, double part, const Each& each) {
    const int count = appearance.is_plain(t) ? 1 : std::max(1, static_cast<int>(std::ceil(part * points_per_region)));
    double u = 1.0 / 3, v = 1.0 / 3;
    for (int i = 0; i < count; ++i) {
        if (i > 0) u = std::fmod(u + 0.7548776662466927, 1.0), v = std::fmod(v + 0.5698402909980532, 1.0);
        const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
        each(Eigen::Vector3d(1 - a - b, a, b).cast<float>(), 1.0 / count);
    }
}

RegionColors measure_colors(const Object& object, const RegionMeasurements& region) {
    const Appearance& appearance = *object.appearance;
    RegionColors result;
    double lightness = 0, a = 0, b = 0, squares = 0, area = 0, metallic = 0, roughness = 0, metallic_area = 0,
           roughness_area = 0;
    for (const std::int32_t triangle : region.triangles) {
        const auto t = static_cast<std::size_t>(triangle);
        const double size = object.geometry.areas[t];
        area += size;
        if (const Material* material = appearance.material_of(t)) {
            if (material->metallic) metallic += size * *material->metallic, metallic_area += size;
            if (material->roughness) roughness += size * *material->roughness, roughness_area += size;
        }
        const double part = region.area > 0 ? size / region.area : 0;
        for_each_point(appearance, t, part, [&](const Eigen::Vector3f& weights, double share) {
            const Color color = appearance.color_at(t, weights);
            if (!is_known(color)) return;
            const Lab lab = lab_from_linear(color);
            const double weight = size * share;
            result.known += weight;
            lightness += weight * lab.lightness, a += weight * lab.a, b += weight * lab.b;
            squares += weight * (lab.lightness * lab.lightness + lab.a * lab.a + lab.b * lab.b);
            result.chroma += weight * lab.chroma();
            const std::array<double, 11> names = name_color(lab);
            for (std::size_t i = 0; i < names.size(); ++i) result.names[i] += weight * names[i];
        });
    }
    if (metallic_area > least_known * area) result.metallic = metallic / metallic_area;
    if (roughness_area > least_known * area) result.roughness = roughness / roughness_area;
    if (!(result.known > 0)) return result;
    const double known = result.known;
    result.mean = {lightness / known, a / known, b / known};
    const Lab& mean = result.mean;
    result.spread =
        std::sqrt(std::max(0.0, squares / known - mean.lightness * mean.lightness - mean.a * mean.a - mean.b * mean.b));
    result.chroma /= known;
    for (double& name : result.names) name /= known;
    result.known = area > 0 ? known / area : 0;
    return result;
}

/// A number from the colours; nothing where too little is told.
template <class Number>
double of_colors(const Object& object, const RegionMeasurements& region, const Number& number) {
    if (!object.appearance) return nothing;
    const RegionColors& colors = look_at_colors(object, region);
    return colors.known >= least_known ? number(colors) : nothing;
}

template <std::size_t name>
double share_of(const Object& object, const RegionMeasurements& region) {
    return of_colors(object, region, [](const RegionColors& colors) { return colors.names[name]; });
}

double hue(const Object& object, const RegionMeasurements& region) {
    return of_colors(object, region, [](const RegionColors& colors) {
        return colors.mean.chroma() < 0.02 ? nothing : colors.mean.hue_degrees();
    });
}

double hue_from_red(const Object& object, const RegionMeasurements& region) {
    const double degrees = hue(object, region) - degrees_of_red;
    return degrees >= 180 ? degrees - 360 : degrees;
}

template <double RegionPattern::*number>
double of_pattern(const Object& object, const RegionMeasurements& region) {
    return of_colors(object, region, [&](const RegionColors&) { return look_at_pattern(object, region).*number; });
}

template <std::optional<double> RegionColors::*number>
double of_finish(const Object& object, const RegionMeasurements& region) {
    return object.appearance ? (look_at_colors(object, region).*number).value_or(nothing) : nothing;
}

const std::array<Measure, 21> measures = {{
    {"share of black", "1", "share of the region's area that is called black", false, Effort::on_demand, share_of<0>},
    {"share of grey", "1", "share of the region's area that is called grey", false, Effort::on_demand, share_of<1>},
    {"share of white", "1", "share of the region's area that is called white", false, Effort::on_demand, share_of<2>},
    {"share of red", "1", "share of the region's area that is called red", false, Effort::on_demand, share_of<3>},
    {"share of orange", "1", "share of the region's area that is called orange", false, Effort::on_demand, share_of<4>},
    {"share of yellow", "1", "share of the region's area that is called yellow", false, Effort::on_demand, share_of<5>},
    {"share of green", "1", "share of the region's area that is called green", false, Effort::on_demand, share_of<6>},
    {"share of blue", "1", "share of the region's area that is called blue", false, Effort::on_demand, share_of<7>},
    {"share of purple", "1", "share of the region's area that is called purple", false, Effort::on_demand, share_of<8>},
    {"share of pink", "1", "share of the region's area that is called pink", false, Effort::on_demand, share_of<9>},
    {"share of brown", "1", "share of the region's area that is called brown", false, Effort::on_demand, share_of<10>},
    {"hue", "degrees", "hue of the mean colour in OKLCh, 0 to 360; nothing for grey", false, Effort::on_demand, hue},
    {"hue from red", "degrees", "the same from -180 to 180: 0 is red, 81 yellow, -125 blue", false, Effort::on_demand,
     hue_from_red},
    {"lightness", "1", "lightness of the mean colour in OKLCh: 0 black, 0.6 middle grey, 1 white", false,
     Effort::on_demand,
     [](const Object& o, const RegionMeasurements& r) {
         return of_colors(o, r, [](const RegionColors& c) { return c.mean.lightness; });
     }},
    {"chroma", "1", "mean chroma in OKLCh: 0 grey, 0.1 muted, 0.3 the most vivid colours", false, Effort::on_demand,
     [](const Object& o, const RegionMeasurements& r) {
         return of_colors(o, r, [](const RegionColors& c) { return c.chroma; });
     }},
    {"colour spread", "1", "root mean square distance of the colours from their mean in OKLab; 0.02 is just seen",
     false, Effort::on_demand,
     [](const Object& o, const RegionMeasurements& r) {
         return of_colors(o, r, [](const RegionColors& c) { return c.spread; });
     }},
    {"stripes", "1", "share of the colours' variance in one wave, beyond a wave that crosses it", false,
     Effort::on_demand, of_pattern<&RegionPattern::stripes>},
    {"checks", "1", "share of the colours' variance in two waves that cross", false, Effort::on_demand,
     of_pattern<&RegionPattern::checks>},
    {"grain", "1", "share of the colours' variance that is fine and in no wave", false, Effort::on_demand,
     of_pattern<&RegionPattern::grain>},
    {"metallic", "1", "mean metallic factor of the materials", false, Effort::on_demand,
     of_finish<&RegionColors::metallic>},
    {"roughness", "1", "mean roughness of the materials: 0 mirror, 1 chalk", false, Effort::on_demand,
     of_finish<&RegionColors::roughness>},
}};

}  // namespace

std::span<const Measure> appearance_measures() { return measures; }

AppearanceNeed appearance_need(const Measure& measure) {
    const std::string_view name = measure.name;
    if (std::ranges::none_of(measures, [&](const Measure& each) { return name == each.name; }))
        return AppearanceNeed::none;
    if (name == "metallic" || name == "roughness") return AppearanceNeed::finish;
    return AppearanceNeed::colors;
}

AppearanceNeed appearance_need(const Formula& formula) {
    AppearanceNeed need = AppearanceNeed::none;
    for (const Formula::Step& step : formula.steps)
        if (step.measure) need = std::max(need, appearance_need(*step.measure));
    return need;
}

bool tells(const Object& object, AppearanceNeed need) {
    if (need == AppearanceNeed::none) return true;
    if (!object.appearance) return false;
    return need != AppearanceNeed::finish || std::ranges::any_of(object.appearance->materials, [](const Material& m) {
               return m.metallic.has_value() || m.roughness.has_value();
           });
}

bool needs_appearance(const Catalogue& catalogue) {
    return std::ranges::any_of(catalogue.algorithms,
                               [](const ElementaryAlgorithm& a) { return a.look != AppearanceNeed::none; });
}

const RegionColors& look_at_colors(const Object& object, const RegionMeasurements& region) {
    if (!region.colors) region.colors = std::make_shared<const RegionColors>(measure_colors(object, region));
    return *region.colors;
}

void paint(Object& object, std::shared_ptr<const Appearance> appearance) {
    object.appearance = std::move(appearance);
    if (object.appearance) split_by_color(object);
}

}  // namespace partonomy
