#include "examples/objects.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "examples/solid.h"

// The paper shows its seven meshes only as small pictures; Table 1 gives their numbers of parts and triangles. A closed
// surface of genus g with V vertices has F = 2 V - 4 + 4 g triangles however it is triangulated, so the table's F
// fixes V:
//
//   object           parts    F      V   g   made of (vertices that each part adds)
//   bench              4     36     20   0   seat 8, two board legs 4 each, backrest 4
//   bench2             6     52     28   0   seat 8, four legs 4 each, backrest 4
//   chair              6     52     28   0   the same
//   chair2             8     82     41   1   seat 8, four legs 4 each, two posts 4 each, backrest 8, one more on
//                                            its front
//   couch              6     52     28   0   as the chair, wide and thick
//   curved-bench      29   2542   1273   0   a polar grid of blocks, see curved_bench()
//   strange-object2    9    100     50   1   chair2 41, a board among the feet 8, one more on the rear of the backrest
//
// All counts are those of Table 1. A rectangular backrest with borders of its own would add 6 vertices and a square leg
// 6 as well, so the counts dictate two shapes:
// - Backrests (but chair2's and the curved bench's) are gables: a triangular board whose base runs along the whole rear
//   edge of the seat. A flush rectangle adds as few vertices, but leaves none between ground and top at the rear
//   corners, and triangles would run over leg, seat and backrest.
// - Legs are three-edged sticks at the corners of the seat, their foot an equilateral triangle that stands a little
//   outside of the corner. The corner below the seat is no vertex: leg and seat meet in a mitre from the top corner
//   of the seat to the two points where the inner edges of the leg join its lower edges.
// Each border between parts runs along edges; triangles beside a mitre belong to the part that holds most of their
// area.

namespace partonomy {
namespace {

using Vertex = Solid::Vertex;
using Four =
    std::array<Vertex, 4>;  // by corner, counter-clockwise from above: front left, front right, rear right, rear left

struct Sizes {
    double width, depth;           ///< of the seat, along x and y; the front is y = 0
    double seat_top, seat_bottom;  ///< heights
    double leg;                    ///< from the corner to the inner edges of a leg, or thickness of a board leg
    double backrest_top = 0, backrest_thickness = 0;
};

Four rectangle(Solid& solid, double x0, double x1, double y0, double y1, double z) {
    return {solid.at(x0, y0, z), solid.at(x1, y0, z), solid.at(x1, y1, z), solid.at(x0, y1, z)};
}

std::vector<Vertex> list(const Four& four) { return {four.begin(), four.end()}; }

/// Where the gable's front stands on the side edges of the seat: left, right.
std::pair<Vertex, Vertex> gable_front(Solid& solid, const Sizes& s) {
    const double y = s.depth - s.backrest_thickness;
    return {solid.at(0, y, s.seat_top), solid.at(s.width, y, s.seat_top)};
}

void add_gable(Solid& solid, const Sizes& s, const Four& top) {
    const auto [left, right] = gable_front(solid, s);
    const Vertex front = solid.at(s.width / 2, s.depth - s.backrest_thickness, s.backrest_top);
    const Vertex rear = solid.at(s.width / 2, s.depth, s.backrest_top);
    solid.begin_part("Backrest");
    solid.face({left, right, front});
    solid.face({top[2], top[3], rear});
    solid.face({right, top[2], rear, front});
    solid.face({top[3], left, front, rear});
}

/// A seat with a leg at each corner c. Of the leg's three edges, one runs from the top corner of the seat down to
/// `foot`, one from the seat's lower edge towards the next corner (`next`), and one from that towards the previous
/// corner (`previous`).
struct SeatOnLegs {
    Four top, next, previous;
    /// The lower side of the seat between the legs, counter-clockwise from above.
    [[nodiscard]] std::vector<Vertex> lower_side() const {
        return {next[0], previous[1], next[1], previous[2], next[2], previous[3], next[3], previous[0]};
    }
};

SeatOnLegs add_legs(Solid& solid, const Sizes& s) {
    const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(s.width, 0, 0), Vec3(s.width, s.depth, 0),
                                      Vec3(0, s.depth, 0)};
    // A right isosceles triangle with its tip pulled out by this much is equilateral.
    const double pulled_out = s.leg * (std::sqrt(3.0) - 1) / 2;
    SeatOnLegs seat{};
    for (std::size_t c = 0; c < 4; ++c) {
        const Vec3 to_next = (corners[(c + 1) % 4] - corners[c]).normalized();
        const Vec3 to_previous = (corners[(c + 3) % 4] - corners[c]).normalized();
        const Vec3 below = Vec3(0, 0, s.seat_bottom);
        const Vertex top = seat.top[c] = solid.at(corners[c] + Vec3(0, 0, s.seat_top));
        const Vertex next = seat.next[c] = solid.at(corners[c] + s.leg * to_next + below);
        const Vertex previous = seat.previous[c] = solid.at(corners[c] + s.leg * to_previous + below);
        const Vertex foot = solid.at(corners[c] - pulled_out * (to_next + to_previous));
        const Vertex next_foot = solid.at(corners[c] + s.leg * to_next);
        const Vertex previous_foot = solid.at(corners[c] + s.leg * to_previous);
        solid.begin_part("Leg");
        solid.face({foot, next, top});
        solid.face({foot, next_foot, next});
        solid.face({foot, top, previous});
        solid.face({previous_foot, foot, previous});
        solid.face({next_foot, previous_foot, previous, next});
        solid.face({foot, previous_foot, next_foot});
    }
    return seat;
}

/// The four sides of the seat; a gable stands on the side edges.
void add_seat_sides(Solid& solid, const Sizes& s, const SeatOnLegs& seat) {
    const auto& [top, next, previous] = seat;
    const auto [left, right] = gable_front(solid, s);
    solid.face({next[0], previous[1], top[1], top[0]});
    solid.face({next[1], previous[2], top[2], right, top[1]});
    solid.face({next[2], previous[3], top[3], top[2]});
    solid.face({next[3], previous[0], top[0], left, top[3]});
}

ExampleObject four_legs(const Sizes& s, const std::string& name, const std::string& object_class) {
    Solid solid;
    const SeatOnLegs seat = add_legs(solid, s);
    const auto [left, right] = gable_front(solid, s);
    solid.begin_part("Seat");
    add_seat_sides(solid, s, seat);
    solid.face({seat.top[0], seat.top[1], right, left});
    solid.face(seat.lower_side(), true);
    add_gable(solid, s, seat.top);
    return std::move(solid).finish(name, object_class);
}

/// A U of three boards, extruded over the depth of the seat, and a gable. Legs and seat meet in mitres.
ExampleObject bench() {
    const Sizes s{1.2, 0.4, 0.27, 0.23, 0.04, 0.7, 0.04};
    Solid solid;
    const Four top = rectangle(solid, 0, s.width, 0, s.depth, s.seat_top);
    const Four outer = rectangle(solid, 0, s.width, 0, s.depth, 0);
    const Four inner = rectangle(solid, s.leg, s.width - s.leg, 0, s.depth, 0);
    const Four lower = rectangle(solid, s.leg, s.width - s.leg, 0, s.depth, s.seat_bottom);
    const auto [left, right] = gable_front(solid, s);
    solid.begin_part("Leg");
    solid.face({outer[3], outer[0], top[0], left, top[3]});
    solid.face({inner[0], inner[3], lower[3], lower[0]});
    solid.face({outer[0], inner[0], lower[0], top[0]});
    solid.face({inner[3], outer[3], top[3], lower[3]});
    solid.face({outer[3], inner[3], inner[0], outer[0]});
    solid.begin_part("Leg");
    solid.face({outer[1], outer[2], top[2], right, top[1]});
    solid.face({inner[2], inner[1], lower[1], lower[2]});
    solid.face({inner[1], outer[1], top[1], lower[1]});
    solid.face({outer[2], inner[2], lower[2], top[2]});
    solid.face({inner[2], outer[2], outer[1], inner[1]});
    solid.begin_part("Seat");
    solid.face({top[0], top[1], right, left});
    solid.face(list(lower), true);
    solid.face({lower[0], lower[1], top[1], top[0]});
    solid.face({lower[2], lower[3], top[3], top[2]});
    add_gable(solid, s, top);
    return std::move(solid).finish("bench", "Bench");
}

/// A backrest board carried by two three-edged posts that stand on the rear corners of the seat; on request with a
/// board that stands among the feet, and a vertex more on the rear of the backrest.
Solid chair_with_posts(bool has_board_among_feet) {
    const Sizes s{0.44, 0.42, 0.43, 0.39, 0.045, 0.9, 0.05};
    const double backrest_bottom = 0.65, post = 0.05;
    const double rear = s.depth, front = s.depth - s.backrest_thickness, tip = s.depth - post * std::sqrt(3.0) / 2;
    Solid solid;
    const SeatOnLegs seat = add_legs(solid, s);
    const auto& [top, next, previous] = seat;
    const auto right_post = [&](double z) {
        return std::array{solid.at(s.width, rear, z), solid.at(s.width - post, rear, z),
                          solid.at(s.width - post / 2, tip, z)};
    };
    const auto left_post = [&](double z) {
        return std::array{solid.at(0, rear, z), solid.at(post / 2, tip, z), solid.at(post, rear, z)};
    };
    const auto right = right_post(s.seat_top), right_end = right_post(backrest_bottom);
    const auto left = left_post(s.seat_top), left_end = left_post(backrest_bottom);
    solid.begin_part("Seat");
    solid.face({next[0], previous[1], top[1], top[0]});
    solid.face({next[1], previous[2], top[2], top[1]});
    solid.face({next[2], previous[3], top[3], left[2], right[1], top[2]});
    solid.face({next[3], previous[0], top[0], top[3]});
    solid.face({top[0], top[1], top[2], right[2], right[1], left[2], left[1], top[3]});
    Four board{};
    if (has_board_among_feet) {
        board = rectangle(solid, 0.1, 0.34, 0.195, 0.225, s.seat_bottom);
        solid.face({previous[0], next[0], previous[1], next[1], board[1], board[0]}, true);
        solid.face({next[1], previous[2], board[2], board[1]}, true);
        solid.face({previous[2], next[2], previous[3], next[3], board[3], board[2]}, true);
        solid.face({next[3], previous[0], board[0], board[3]}, true);
    } else {
        solid.face(seat.lower_side(), true);
    }
    for (const auto& [base, end] : {std::pair(right, right_end), std::pair(left, left_end)}) {
        solid.begin_part("BackPost");
        for (std::size_t i = 0; i < 3; ++i) solid.face({base[i], base[(i + 1) % 3], end[(i + 1) % 3], end[i]});
    }
    const Four low = rectangle(solid, 0, s.width, front, rear, backrest_bottom);
    const Four high = rectangle(solid, 0, s.width, front, rear, s.backrest_top);
    const double middle_height = (backrest_bottom + s.backrest_top) / 2;
    const Vertex middle = solid.at(s.width / 2, front, middle_height);
    solid.begin_part("Backrest");
    solid.face({low[0], low[1], low[2], right_end[2], right_end[1], left_end[2], left_end[1], low[3]}, true);
    const std::vector<Vertex> rear_side{low[2], right_end[1], left_end[2], low[3], high[3], high[2]};
    if (has_board_among_feet) {
        const Vertex rear_middle = solid.at(s.width / 2, rear, middle_height);
        for (std::size_t i = 0; i < rear_side.size(); ++i)
            solid.face({rear_side[i], rear_side[(i + 1) % rear_side.size()], rear_middle});
    } else {
        solid.face(rear_side);
    }
    for (const auto& [a, b] : {std::pair(low[0], low[1]), {low[1], high[1]}, {high[1], high[0]}, {high[0], low[0]}})
        solid.face({a, b, middle});
    solid.face({low[1], low[2], high[2], high[1]});
    solid.face({low[3], low[0], high[0], high[3]});
    solid.face(list(high));
    if (has_board_among_feet) {
        solid.begin_part("Leg");
        solid.prism(list(board), 0);
    }
    return solid;
}

ExampleObject chair2() { return chair_with_posts(false).finish("chair2", "Chair"); }

/// The rules of furniture forbid a board among the feet of a chair (paper Fig. 14).
ExampleObject strange_object2() {
    return chair_with_posts(true).finish("strange-object2", "Chair", "FootIncompatibleFurnitures");
}

/// The corners of a three-edged post that stands on the rear edge of a board, its right end at x: right, left, front.
std::array<Vertex, 3> rear_post(Solid& solid, double x, double thickness, double rear, double z) {
    return {solid.at(x, rear, z), solid.at(x - thickness, rear, z),
            solid.at(x - thickness / 2, rear - thickness * std::sqrt(3.0) / 2, z)};
}

/// An upright board from y = front to rear on two posts (corners at its lower side), with two more on its upper side.
void add_board_on_posts(Solid& solid, const std::string& label, double x0, double x1, double front, double rear,
                        double z0, double z1, const std::array<std::array<Vertex, 3>, 2>& below,
                        const std::vector<std::array<Vertex, 3>>& above) {
    const Four low = rectangle(solid, x0, x1, front, rear, z0), high = rectangle(solid, x0, x1, front, rear, z1);
    solid.begin_part(label);
    std::vector<Vertex> lower{low[0], low[1], low[2]}, upper{high[0], high[1], high[2]};
    std::vector<Vertex> rear_side{low[2]};
    for (const auto& [right, left, tip] : below) {
        lower.insert(lower.end(), {right, tip, left});
        rear_side.insert(rear_side.end(), {right, left});
    }
    lower.push_back(low[3]);
    rear_side.insert(rear_side.end(), {low[3], high[3]});
    for (const auto& [right, left, tip] : above) upper.insert(upper.end(), {right, tip, left});
    upper.push_back(high[3]);
    for (std::size_t i = above.size(); i-- > 0;) rear_side.insert(rear_side.end(), {above[i][1], above[i][0]});
    rear_side.push_back(high[2]);
    solid.face(lower, true);
    solid.face(upper);
    solid.face(rear_side);
    solid.face({low[0], low[1], high[1], high[0]});
    solid.face({low[1], low[2], high[2], high[1]});
    solid.face({low[3], low[0], high[0], high[3]});
}

// The curved bench is cut by a polar grid: 61 columns between angles, 7 rings between radii. The seat fills the grid
// between two heights; a slat stands on one cell, a leg hangs under one cell. Columns: 4 at either end, 3 in each of
// the 13 gaps between the 14 slats, and one under each slat, 4 + 14 + 39 + 4 = 61. Every other gap has two legs under
// its middle column. Quadrilaterals: 2 * 61 * 7 top and bottom + 2 * 61 + 2 * 7 walls + 14 * 4 * 3 slats + 14 * 4 * 2
// legs = 1270, and a vertex in the middle of one of them: 2 * 1270 + 2 = 2542 triangles.

struct Polar {
    std::vector<double> angles, radii;
    Solid& solid;
    [[nodiscard]] Vertex at(std::size_t column, std::size_t ring, double z) const {
        return solid.at(radii[ring] * std::cos(angles[column]), radii[ring] * std::sin(angles[column]), z);
    }
    /// The lower corners of a cell at height z, counter-clockwise from above.
    [[nodiscard]] std::vector<Vertex> cell(std::size_t column, std::size_t ring, double z) const {
        return {at(column, ring, z), at(column, ring + 1, z), at(column + 1, ring + 1, z), at(column + 1, ring, z)};
    }
};

std::vector<double> column_angles() {
    constexpr double outer_radius = 1.96, slat = 0.12 / outer_radius, leg = 0.05 / outer_radius;
    constexpr double beside_leg = 0.02 / outer_radius, end = 0.03 / outer_radius;
    std::vector<double> widths(4, end);
    for (int i = 0; i < 14; ++i) {
        if (i > 0) widths.insert(widths.end(), {beside_leg, leg, beside_leg});
        widths.push_back(slat);
    }
    widths.insert(widths.end(), 4, end);
    double total = 0;
    for (const double width : widths) total += width;
    std::vector<double> angles{std::numbers::pi / 2 - total / 2};
    for (const double width : widths) angles.push_back(angles.back() + width);
    return angles;
}

/// A block in `steps` storeys over or under one cell, without the face where it joins the seat.
void add_block(const Polar& grid, std::size_t column, std::size_t ring, double from, double to, int steps) {
    const bool down = to < from;
    for (int step = 0; step < steps; ++step) {
        const auto height = [&](int i) { return i == steps ? to : from + (to - from) * i / steps; };
        const auto base = grid.cell(column, ring, height(step)), lid = grid.cell(column, ring, height(step + 1));
        for (std::size_t i = 0; i < 4; ++i)
            grid.solid.face({base[i], base[(i + 1) % 4], lid[(i + 1) % 4], lid[i]}, down);
    }
    grid.solid.face(grid.cell(column, ring, to), down);
}

ExampleObject curved_bench() {
    constexpr double seat_top = 0.27, seat_bottom = 0.23, slat_top = 0.72;
    constexpr std::size_t first_slat = 4, period = 4, front_legs = 1, rear_legs = 3, slats = 5;  // columns, rings
    Solid solid;
    const Polar grid{column_angles(), {1.6, 1.65, 1.7, 1.85, 1.9, 1.93, 1.96, 2.0}, solid};
    const std::size_t columns = grid.angles.size() - 1, rings = grid.radii.size() - 1;
    const auto has_slat = [&](std::size_t column, std::size_t ring) {
        return ring == slats && column >= first_slat && column < columns - 4 && (column - first_slat) % period == 0;
    };
    const auto has_leg = [&](std::size_t column, std::size_t ring) {
        return (ring == front_legs || ring == rear_legs) && column > first_slat && column < columns - 4 &&
               (column - first_slat) % (2 * period) == 2;
    };
    solid.begin_part("Seat");
    for (std::size_t c = 0; c < columns; ++c) {
        for (std::size_t r = 0; r < rings; ++r) {
            if (!has_slat(c, r)) {
                const auto cell = grid.cell(c, r, seat_top);
                if (c == columns / 2 && r == 2) {  // the one extra vertex
                    const Vertex middle = solid.at((solid.position(cell[0]) + solid.position(cell[2])) / 2);
                    for (std::size_t i = 0; i < 4; ++i) solid.face({cell[i], cell[(i + 1) % 4], middle});
                } else {
                    solid.face(cell);
                }
            }
            if (!has_leg(c, r)) solid.face(grid.cell(c, r, seat_bottom), true);
        }
        const auto wall = [&](std::size_t ring, bool reversed) {
            solid.face({grid.at(c, ring, seat_bottom), grid.at(c + 1, ring, seat_bottom),
                        grid.at(c + 1, ring, seat_top), grid.at(c, ring, seat_top)},
                       reversed);
        };
        wall(0, true);
        wall(rings, false);
    }
    for (std::size_t r = 0; r < rings; ++r) {
        const auto wall = [&](std::size_t column, bool reversed) {
            solid.face({grid.at(column, r, seat_bottom), grid.at(column, r + 1, seat_bottom),
                        grid.at(column, r + 1, seat_top), grid.at(column, r, seat_top)},
                       reversed);
        };
        wall(0, false);
        wall(columns, true);
    }
    for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t r = 0; r < rings; ++r) {
            if (has_slat(c, r)) {
                solid.begin_part("Backrest");
                add_block(grid, c, r, seat_top, slat_top, 3);
            }
            if (has_leg(c, r)) {
                solid.begin_part("Leg");
                add_block(grid, c, r, seat_bottom, 0, 2);
            }
        }
    return std::move(solid).finish("curved-bench", "Bench");
}

}  // namespace

ExampleObject headrest_chair(bool has_backrest) {
    const Sizes s{0.44, 0.42, 0.43, 0.39, 0.045};
    const double rear = s.depth, front = 0.37, post = has_backrest ? 0.04 : 0.05, neck = 0.025;
    Solid solid;
    const SeatOnLegs seat = add_legs(solid, s);
    const auto& [top, next, previous] = seat;
    const auto posts_at = [&](double left, double right, double thickness, double z) {
        return std::array{rear_post(solid, right, thickness, rear, z), rear_post(solid, left, thickness, rear, z)};
    };
    const auto add_posts = [&](const std::array<std::array<Vertex, 3>, 2>& bases,
                               const std::array<std::array<Vertex, 3>, 2>& ends) {
        for (std::size_t p = 0; p < 2; ++p) {
            solid.begin_part("BackPost");
            for (std::size_t i = 0; i < 3; ++i)
                solid.face({bases[p][i], bases[p][(i + 1) % 3], ends[p][(i + 1) % 3], ends[p][i]});
        }
    };
    const double left = has_backrest ? 0.09 : 0.17, right = has_backrest ? 0.39 : 0.31;
    const auto bases = posts_at(left, right, post, s.seat_top);
    solid.begin_part("Seat");
    solid.face({next[0], previous[1], top[1], top[0]});
    solid.face({next[1], previous[2], top[2], top[1]});
    solid.face({next[2], previous[3], top[3], bases[1][1], bases[1][0], bases[0][1], bases[0][0], top[2]});
    solid.face({next[3], previous[0], top[0], top[3]});
    solid.face(
        {top[0], top[1], top[2], bases[0][0], bases[0][2], bases[0][1], bases[1][0], bases[1][2], bases[1][1], top[3]});
    solid.face(seat.lower_side(), true);
    const double headrest_bottom = 0.95, headrest_top = 1.15;
    if (has_backrest) {
        const auto ends = posts_at(left, right, post, 0.55);
        add_posts(bases, ends);
        const auto neck_bases = posts_at(0.18, 0.285, neck, 0.85),
                   neck_ends = posts_at(0.18, 0.285, neck, headrest_bottom);
        add_board_on_posts(solid, "BackPanel", 0, s.width, front, rear, 0.55, 0.85, ends,
                           {neck_bases[0], neck_bases[1]});
        add_posts(neck_bases, neck_ends);
        add_board_on_posts(solid, "Headrest", 0.07, 0.37, front, rear, headrest_bottom, headrest_top, neck_ends, {});
        return std::move(solid).finish("headrest-chair", "HeadrestChair");
    }
    const auto ends = posts_at(left, right, post, headrest_bottom);
    add_posts(bases, ends);
    add_board_on_posts(solid, "Headrest", 0.07, 0.37, front, rear, headrest_bottom, headrest_top, ends, {});
    return std::move(solid).finish("headrest-only", "Chair", "HeadrestWithoutBackrest");
}

std::vector<ExampleObject> paper_objects() {
    std::vector<ExampleObject> objects;
    objects.push_back(bench());
    objects.push_back(four_legs({1.2, 0.4, 0.27, 0.23, 0.04, 0.7, 0.04}, "bench2", "Bench"));
    objects.push_back(four_legs({0.44, 0.42, 0.43, 0.39, 0.045, 0.88, 0.04}, "chair", "Chair"));
    objects.push_back(chair2());
    objects.push_back(four_legs({1.9, 0.7, 0.43, 0.29, 0.1, 0.85, 0.12}, "couch", "Couch"));
    objects.push_back(curved_bench());
    objects.push_back(strange_object2());
    return objects;
}

ExampleObject paper_object(const std::string& name) {
    for (ExampleObject& object : paper_objects())
        if (object.name == name) return std::move(object);
    throw UsageError("there is no example object '" + name +
                     "'; there are bench, bench2, chair, chair2, couch, curved-bench and strange-object2");
}

}  // namespace partonomy
