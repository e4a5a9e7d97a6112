// A street along x. Ground from 0 to 0.4; the road on it; a pavement at either side of the road, its kerb 10 cm higher;
// behind each pavement a row of buildings. Pavements are divided into slots that hold a lamp post, a tree, a bench or
// nothing; cars stand at the kerb. All sizes are drawn at random within what one sees in a town.

#include "examples/street.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/errors.h"
#include "examples/blocks.h"

namespace partonomy {
namespace {

constexpr double ground_top = 0.4, road_top = 0.45, pavement_top = 0.55;
constexpr double road_half = 4, pavement_end = 7;

/// A building in its own coordinates: the front looks along -y, from x = 0 to `width`, the foot of its walls at z = 0.
struct Building {
    double width = 0, depth = 0, height = 0;
    int floors = 2;
    BuildingStyle style = BuildingStyle::slabs;
    bool has_gable = false, has_roof = true;
    double door_foot = 0;  ///< above the walls' foot
    double door_at = 0;    ///< x of the door's middle
};

class Street {
public:
    explicit Street(const StreetOptions& options) : options_(options), random_(options.seed) {
        length_ = 0;
        for (const double side : {-1.0, 1.0}) add_buildings(side);
        add_ground();
        for (const double side : {-1.0, 1.0}) furnish(side);
        add_cars();
        if (has_fault("LampInRoad")) add_lamp({uniform(0.3, 0.7) * length_, uniform(-1.5, 1.5), road_top});
        if (has_fault("TreeInRoad")) add_tree({uniform(0.1, 0.25) * length_, uniform(-1.5, 1.5), road_top});
        if (has_fault("CarOnPavement")) add_car({0.5 * length_, 5.6, pavement_top}, 0);
    }
    ShapeScene scene;
    int trees = 0;

private:
    double uniform(double low, double high) {  // the same numbers with any standard library
        return low + (high - low) * static_cast<double>(random_() >> 11U) / 9007199254740992.0;
    }
    int integer(int low, int high) { return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)); }
    [[nodiscard]] bool has_fault(const std::string& name) const {
        return std::ranges::find(options_.faults, name) != options_.faults.end();
    }

    void add_box(const Pose& pose, const Vec3& low, const Vec3& high, const std::string& label) {
        scene.shapes.push_back({.pose = pose, .blocks = {{low, high, label}}, .label = {}});
    }
    void add_cone(const Vec3& foot, double radius, double upper, double height, const std::string& label) {
        scene.shapes.push_back({.kind = Shape::Kind::cone,
                                .pose = {foot, 0},
                                .blocks = {},
                                .height = height,
                                .radius = radius,
                                .upper_radius = upper,
                                .label = label});
    }
    void add_ball(const Vec3& foot, double radius, double height, const std::string& label) {
        scene.shapes.push_back({.kind = Shape::Kind::ball,
                                .pose = {foot, 0},
                                .blocks = {},
                                .height = height,
                                .radius = radius,
                                .label = label});
    }

    void add_ground() {
        const double end = length_ + 3, side = pavement_end + 17;
        add_box({}, {-3, -side, 0}, {end, side, ground_top}, "Ground");
        add_box({}, {-3, -road_half, ground_top}, {end, road_half, road_top}, "Road");
        add_box({}, {-3, road_half, ground_top}, {end, pavement_end, pavement_top}, "Pavement");
        add_box({}, {-3, -pavement_end, ground_top}, {end, -road_half, pavement_top}, "Pavement");
    }

    void add_buildings(double side) {
        double x = uniform(0, 2);
        for (int i = 0; i < options_.buildings_a_side; ++i) {
            Building b;
            const bool is_first = i == 0 && side < 0, is_second = i == 1 && side < 0;
            b.floors = is_first && has_fault("DoorOntoNothing") ? 3 : integer(1, 3);
            b.width = uniform(8, 13), b.depth = uniform(7, 11), b.height = b.floors * 3.0 + 0.4;
            b.style =
                options_.style == BuildingStyle::mixed ? static_cast<BuildingStyle>(integer(0, 2)) : options_.style;
            b.has_gable = integer(0, 1) == 1;
            b.has_roof = !(is_second && has_fault("RooflessWall"));
            b.door_at = uniform(1.2, b.width - 1.2);
            b.door_foot = is_first && has_fault("DoorOntoNothing") ? 3.1 : 0.02;
            const double front = pavement_end + uniform(0.6, 3);
            Pose pose{{x, front, ground_top}, 0};
            if (side < 0) pose = {{x + b.width, -front, ground_top}, 180};
            add_building(b, pose);
            if ((has_fault("DoorOntoNothing") ? is_second : is_first) && has_fault("BlockedDoor"))
                add_tree(pose({b.door_at, -0.5, 0}));
            x += b.width + uniform(2, 5);
        }
        length_ = std::max(length_, x);
    }

    /// Openings of one wall, as (from, to) along it and in height; the door first on the front.
    struct Opening {
        double from, to, low, high;
        bool is_door;
    };
    std::vector<Opening> openings(const Building& b, double wall, bool is_front) {
        std::vector<Opening> result;
        const double half = 0.45, window = uniform(0.9, 1.3);
        if (is_front) result.push_back({b.door_at - half, b.door_at + half, b.door_foot, b.door_foot + 2.1, true});
        for (int floor = 0; floor < b.floors; ++floor) {
            const int count = static_cast<int>((wall - 1) / 2.8);
            for (int i = 0; i < count; ++i) {
                const double middle = wall * (i + 0.5) / count, low = 3.0 * floor + 1;
                const bool hits_door = is_front && std::abs(middle - b.door_at) < half + window / 2 + 0.2 &&
                                       low < b.door_foot + 2.3 && low + 1.3 > b.door_foot - 0.2;
                if (!hits_door) result.push_back({middle - window / 2, middle + window / 2, low, low + 1.3, false});
            }
        }
        return result;
    }

    /// Openings of all four walls as boxes, from `inner` to `outer` of the walls' outer side.
    std::vector<Block> boards(const Building& b, double inner, double outer) {
        std::vector<Block> result;
        int part = 1;
        for (int wall = 0; wall < 4; ++wall) {
            const bool is_along = wall % 2 == 0;  // front and rear, then the sides
            for (const Opening& o : openings(b, is_along ? b.width : b.depth, wall == 0)) {
                Block block{{}, {}, o.is_door ? "Door" : "Window", part++};
                const double from = -outer, to = -inner;  // of the front and the left wall
                const double face = is_along ? b.depth : b.width;
                const double low = wall < 2 ? from : face - to, high = wall < 2 ? to : face - from;
                if (is_along)
                    block.low = {o.from, low, o.low}, block.high = {o.to, high, o.high};
                else
                    block.low = {low, o.from, o.low}, block.high = {high, o.to, o.high};
                block.facing[is_along ? 1 : 0] = wall < 2 ? -1 : 1;
                result.push_back(std::move(block));
            }
        }
        return result;
    }

    void add_building(const Building& b, const Pose& pose) {
        constexpr double wall = 0.3, eaves = 0.35;
        const Block roof{{-eaves, -eaves, b.height}, {b.width + eaves, b.depth + eaves, b.height + 0.3}, "Roof"};
        if (b.style == BuildingStyle::carved) {
            Shape shape{.pose = pose, .blocks = {{{0, 0, 0}, {b.width, b.depth, b.height}, "Wall"}}, .label = {}};
            std::vector<Block> holes = boards(b, -0.12, 0);
            for (Block& hole : holes) {
                hole.is_cut = true;
                shape.blocks.push_back(hole);
            }
            if (b.has_roof) shape.blocks.push_back(roof), shape.blocks.back().part = static_cast<int>(holes.size()) + 1;
            scene.shapes.push_back(std::move(shape));
            return;
        }
        if (b.style == BuildingStyle::slabs) {
            add_box(pose, {0, 0, 0}, {b.width, wall, b.height}, "Wall");
            add_box(pose, {0, b.depth - wall, 0}, {b.width, b.depth, b.height}, "Wall");
            add_box(pose, {0, wall, 0}, {wall, b.depth - wall, b.height}, "Wall");
            add_box(pose, {b.width - wall, wall, 0}, {b.width, b.depth - wall, b.height}, "Wall");
        } else {
            add_box(pose, {0, 0, 0}, {b.width, b.depth, b.height}, "Wall");
        }
        const bool is_sunk = b.style == BuildingStyle::slabs;
        for (const Block& board : boards(b, is_sunk ? -0.35 : 0, is_sunk ? 0.04 : 0.07))
            add_box(pose, board.low, board.high, board.label);
        if (!b.has_roof) return;
        if (b.has_gable)
            add_gable(b, pose);
        else
            add_box(pose, roof.low, roof.high, "Roof");
    }

    /// A prism with three sides, its ridge along the front.
    void add_gable(const Building& b, const Pose& pose) {
        constexpr double eaves = 0.35;
        scene.shapes.push_back({.kind = Shape::Kind::gable,
                                .pose = pose,
                                .blocks = {{{-eaves, -eaves, b.height},
                                            {b.width + eaves, b.depth + eaves, b.height + uniform(1.5, 3)},
                                            "Roof"}},
                                .label = {}});
    }

    void add_lamp(const Vec3& foot) {
        const double height = uniform(4, 6.5), radius = uniform(0.05, 0.09);
        add_cone(foot, radius, radius * 0.8, height, "LampPole");
        const Vec3 top = foot + Vec3(0, 0, height);
        if (integer(0, 1) == 0)
            add_ball(top - Vec3(0, 0, 0.04), uniform(0.18, 0.28), 0.45, "LampHead");
        else
            add_box({top, uniform(0, 360)}, {-0.15, -0.15, -0.02}, {0.45, 0.15, 0.13}, "LampHead");
    }

    void add_tree(const Vec3& foot) {
        const double trunk = uniform(1.8, 2.8), radius = uniform(0.1, 0.2), crown = uniform(0.9, 1.4);
        ++trees;
        add_cone(foot, radius, radius * 0.8, trunk, "Trunk");
        if (integer(0, 2) > 0)
            add_ball(foot + Vec3(0, 0, trunk - 0.3), crown, crown * uniform(1.6, 2.4), "Crown");
        else
            add_cone(foot + Vec3(0, 0, trunk - 0.2), crown, 0.05, crown * uniform(2, 3), "Crown");
    }

    void add_bench(const Vec3& foot, double degrees) {
        const double length = uniform(1.4, 2), depth = 0.45, top = 0.46, half = length / 2;
        const bool has_back = integer(0, 1) == 1;
        std::vector<Block> blocks = {{{-half, 0, top - 0.06}, {half, depth, top}, "BenchSeat", 0},
                                     {{-half + 0.15, 0.04, 0}, {-half + 0.25, depth - 0.04, top - 0.06}, "BenchLeg", 1},
                                     {{half - 0.25, 0.04, 0}, {half - 0.15, depth - 0.04, top - 0.06}, "BenchLeg", 2}};
        if (has_back) blocks.push_back({{-half, depth - 0.05, top}, {half, depth, 0.9}, "BenchBack", 3});
        if (integer(0, 1) == 0) {
            scene.shapes.push_back({.pose = {foot, degrees}, .blocks = std::move(blocks), .label = {}});
        } else {
            for (const Block& block : blocks) add_box({foot, degrees}, block.low, block.high, block.label);
        }
    }

    void add_car(const Vec3& at, double degrees) {
        const double length = uniform(3.6, 4.8), width = uniform(1.65, 1.95), height = uniform(1.35, 1.7);
        const Pose pose{at, degrees};
        if (integer(0, 1) == 0) {
            add_box(pose, {-length / 2, -width / 2, 0}, {length / 2, width / 2, height}, "Car");
        } else {
            add_box(pose, {-length / 2, -width / 2, 0}, {length / 2, width / 2, 0.85}, "Car");
            add_box(pose, {-length / 4, -width / 2 + 0.1, 0.85}, {length / 3, width / 2 - 0.1, height}, "Car");
        }
    }

    void furnish(double side) {
        int slot = 0;
        for (double x = 1; x < length_ - 1; x += 4, ++slot) {
            if (slot % 4 == 0)
                add_lamp({x, side * uniform(4.3, 4.6), pavement_top});
            else if (const int kind = integer(0, 3); kind == 0 && options_.has_trees)
                add_tree({x, side * uniform(5, 6), pavement_top});
            else if (kind == 1)
                add_bench({x, side * 5.8, pavement_top}, side > 0 ? uniform(-5, 5) : 180 + uniform(-5, 5));
        }
    }

    void add_cars() {
        for (const double side : {-1.0, 1.0})
            for (double x = uniform(2, 6); x < length_ - 4; x += uniform(6, 14))
                add_car({x, side * uniform(2.7, 2.9), road_top}, uniform(-2, 2));
    }

    const StreetOptions& options_;
    std::mt19937_64 random_;
    double length_ = 0;
};

}  // namespace

ExampleObject street(const StreetOptions& options) {
    constexpr std::array known = {"DoorOntoNothing", "LampInRoad",  "TreeInRoad",
                                  "CarOnPavement",   "BlockedDoor", "RooflessWall"};
    for (const std::string& fault : options.faults)
        if (std::ranges::find(known, fault) == known.end())
            throw UsageError("there is no fault '" + fault +
                             "' of a street; there are DoorOntoNothing, LampInRoad, TreeInRoad, CarOnPavement, "
                             "BlockedDoor and RooflessWall");
    const Street made(options);
    constexpr double coarse = 1000;
    ExampleObject object = made.scene.mesh(options.triangles > 0 ? made.scene.edge_for(options.triangles) : coarse);
    object.name = "street";
    object.object_class = made.trees >= 3 ? "TreeLinedStreet" : made.trees == 0 ? "BareStreet" : "LitStreet";
    if (!options.faults.empty()) object.incompatibility = options.faults.front();
    return object;
}

}  // namespace partonomy
