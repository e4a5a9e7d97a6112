#include "examples/brackets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "base/errors.h"
#include "examples/solid.h"

// Along the plate lie, from its middle line outward: bosses, a rib, a row of holes; the other half is its mirror image
// but for what is wrong. All is drawn in millimetres around the middle of the plate and set into the room at the end.

namespace partonomy {
namespace {

constexpr double pi = std::numbers::pi;
const std::array<std::string, 11> defects{"MissingRib",    "MissingHole",   "HoleAtEdge", "HolesTooClose",
                                          "HoleOutOfLine", "BossTooHigh",   "ExtraBoard", "RibTooThin",
                                          "RibTilted",     "HoleOfOddSize", "MissingBoss"};

/// Numbers that are the same with every standard library.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
    }
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
    }
    double sign() { return whole(0, 1) == 0 ? -1 : 1; }

private:
    std::mt19937 engine_;
};

struct Round {
    double x, y, radius;
    double height = 0;  ///< above the plate
    double bore = 0;    ///< radius; 0 for none
    bool is_through = false;
};

struct Rib {
    double x, y;            ///< middle
    double length, across;  ///< along x and y
    double height;
    double lean = 0;  ///< how far its top is shifted along y
};

struct Plan {
    double length = 0, width = 0, thickness = 0;
    std::vector<Round> holes, bosses;  ///< holes column by column, two each
    std::vector<Rib> ribs;
    int sides = 0;
    [[nodiscard]] double diagonal() const { return std::hypot(length, width); }
};

Plan sound_plan(Dice& dice) {
    Plan plan;
    plan.thickness = dice.between(6, 12);
    plan.sides = dice.whole(16, 48);
    const double hole = dice.between(3, 5.5), edge = dice.between(9, 13);
    const double boss = dice.between(7, 12), rib = dice.between(4, 7);
    const int columns = dice.whole(2, 4), bosses = dice.whole(1, 3);
    const double rib_at = boss + dice.between(5, 9) + rib / 2;
    const double row = rib_at + rib / 2 + dice.between(9, 14) + hole;
    plan.width = 2 * (row + hole + edge);
    const double pitch = 2 * boss + dice.between(8, 20);
    plan.length = std::max({plan.width * dice.between(1.15, 1.6), (bosses - 1) * pitch + 2 * boss + 60, 130.0});
    const double half_row = plan.length / 2 - hole - edge;
    for (int c = 0; c < columns; ++c)
        for (const double side : {-1.0, 1.0})
            plan.holes.push_back({-half_row + 2 * half_row * c / (columns - 1), side * row, hole});
    const double rib_height = rib * dice.between(2.8, 6), rib_length = plan.length * dice.between(0.5, 0.65);
    for (const double side : {-1.0, 1.0}) plan.ribs.push_back({0, side * rib_at, rib_length, rib, rib_height});
    for (int b = 0; b < bosses; ++b) {
        Round round{(b - (bosses - 1) / 2.0) * pitch, 0, boss, 2 * boss * dice.between(0.5, 1)};
        if (dice.whole(0, 1) == 1) {
            round.bore = boss * dice.between(0.35, 0.6);
            round.is_through = dice.whole(0, 1) == 1;
        }
        plan.bosses.push_back(round);
    }
    return plan;
}

void spoil(Plan& plan, const std::string& defect, Dice& dice) {
    const int any_hole = dice.whole(0, static_cast<int>(plan.holes.size()) - 1);
    Round& hole = plan.holes[static_cast<std::size_t>(any_hole)];
    Rib& rib = plan.ribs[static_cast<std::size_t>(dice.whole(0, 1))];
    if (defect == "MissingRib") {
        plan.ribs.erase(plan.ribs.begin() + dice.whole(0, 1));
    } else if (defect == "MissingHole") {
        plan.holes.erase(plan.holes.begin() + any_hole);
    } else if (defect == "HoleAtEdge") {
        const double left = plan.diagonal() * dice.between(0.006, 0.012);
        hole.y = std::copysign(plan.width / 2 - hole.radius - left, hole.y);
    } else if (defect == "HolesTooClose") {  // beside its neighbour in the row
        const Round& other = plan.holes[static_cast<std::size_t>(any_hole < 2 ? any_hole + 2 : any_hole - 2)];
        const double left = plan.diagonal() * dice.between(0.006, 0.012);
        hole.x = other.x + std::copysign(2 * hole.radius + left, hole.x - other.x);
    } else if (defect == "HoleOutOfLine") {
        hole.x -= std::copysign(plan.diagonal() * dice.between(0.03, 0.06), hole.x);
        hole.y -= std::copysign(std::min(8.0, plan.diagonal() * dice.between(0.025, 0.04)), hole.y);
    } else if (defect == "BossTooHigh") {
        Round& boss = plan.bosses[static_cast<std::size_t>(dice.whole(0, static_cast<int>(plan.bosses.size()) - 1))];
        boss.height = 2 * boss.radius * dice.between(1.5, 2.2);
    } else if (defect == "ExtraBoard") {
        const double thick = rib.across * dice.between(0.8, 1), end = plan.length / 2 - 4 - thick / 2;
        const double x = std::min(end, rib.length / 2 + 6 + thick / 2 + dice.between(0, 8));
        const double y = 2 * std::abs(rib.y) * dice.between(0.7, 1);
        plan.ribs.push_back({dice.sign() * x, 0, thick, y, rib.height * dice.between(0.9, 1.1)});
    } else if (defect == "RibTooThin") {
        rib.across = rib.height / dice.between(10.5, 14);
    } else if (defect == "RibTilted") {  // away from the bosses
        rib.lean = std::copysign(rib.height * std::tan(dice.between(14, 24) * pi / 180), rib.y);
    } else if (defect == "HoleOfOddSize") {
        hole.radius *= dice.whole(0, 1) == 0 ? dice.between(0.6, 0.75) : dice.between(1.25, 1.35);
    } else if (defect == "MissingBoss") {
        plan.bosses.clear();
    } else {
        throw UsageError("a bracket cannot have the defect " + defect);
    }
}

ExampleObject build(const Plan& plan, const std::string& name, const std::string& defect) {
    using Ring = std::vector<Solid::Vertex>;
    Solid solid;
    const auto circle = [&](const Round& round, double radius, double z) {
        Ring ring;
        for (int i = 0; i < plan.sides; ++i) {
            const double angle = 2 * pi * (i + 0.5) / plan.sides;
            ring.push_back(solid.at(round.x + radius * std::cos(angle), round.y + radius * std::sin(angle), z));
        }
        return ring;
    };
    const auto rectangle = [&](double x, double y, double length, double width, double z) {
        const double a = length / 2, b = width / 2;
        return Ring{solid.at(x - a, y - b, z), solid.at(x + a, y - b, z), solid.at(x + a, y + b, z),
                    solid.at(x - a, y + b, z)};
    };
    const auto wall = [&](const Ring& low, const Ring& high, bool inward) {
        for (std::size_t i = 0; i < low.size(); ++i) {
            const std::size_t j = (i + 1) % low.size();
            solid.face({low[i], low[j], high[j], high[i]}, inward);
        }
    };
    const double t = plan.thickness;
    const Ring low = rectangle(0, 0, plan.length, plan.width, 0), high = rectangle(0, 0, plan.length, plan.width, t);
    std::vector<Ring> below, above;
    for (const Round& hole : plan.holes) {
        below.push_back(circle(hole, hole.radius, 0));
        above.push_back(circle(hole, hole.radius, t));
        solid.begin_part("BoltHole");
        wall(below.back(), above.back(), true);
    }
    for (const Round& boss : plan.bosses) {
        const Ring foot = circle(boss, boss.radius, t), top = circle(boss, boss.radius, t + boss.height);
        above.push_back(foot);
        solid.begin_part("Boss");
        wall(foot, top, false);
        solid.begin_part("EndFace");
        if (boss.bore == 0) {
            solid.face(top);
            continue;
        }
        const Ring mouth = circle(boss, boss.bore, t + boss.height),
                   end = circle(boss, boss.bore, boss.is_through ? 0 : t);
        solid.face_with_holes(top, {mouth});
        solid.begin_part("Bore");
        wall(end, mouth, true);
        if (boss.is_through) {
            below.push_back(end);
        } else {
            solid.begin_part("EndFace");
            solid.face(end);
        }
    }
    for (const Rib& rib : plan.ribs) {
        above.push_back(rectangle(rib.x, rib.y, rib.length, rib.across, t));
        solid.begin_part("Rib");
        const Ring top = rectangle(rib.x, rib.y + rib.lean, rib.length, rib.across, t + rib.height);
        wall(above.back(), top, false);
        solid.face(top);
    }
    solid.begin_part("Plate");
    solid.face_with_holes(low, below, true);
    wall(low, high, false);
    solid.face_with_holes(high, above);
    return std::move(solid).finish(name, defect.empty() ? "Bracket" : "", defect);
}

}  // namespace

std::span<const std::string> bracket_defects() { return defects; }

ExampleObject bracket(std::uint32_t seed, const std::string& defect) {
    Dice dice(seed);
    Plan plan = sound_plan(dice);
    if (!defect.empty()) spoil(plan, defect, dice);
    ExampleObject object =
        build(plan, "bracket-" + std::to_string(seed) + (defect.empty() ? "" : "-" + defect), defect);
    const double angle = dice.between(0, 2 * pi), scale = dice.whole(0, 1) == 0 ? 1 : 0.001;
    const double x = dice.between(-500, 500), y = dice.between(-500, 500);
    for (Vec3& p : object.mesh.positions)
        p = scale * Vec3(std::cos(angle) * p.x() - std::sin(angle) * p.y() + x,
                         std::sin(angle) * p.x() + std::cos(angle) * p.y() + y, p.z());
    return object;
}

}  // namespace partonomy
