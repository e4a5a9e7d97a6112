/* Final labelling: knowledge repairs segmentation (the open question of paper §6.2).
 *
 * Idea. find_parts cuts by shape alone, and now and then it cuts wrong: a stump of a leg stays apart, a leg and the
 * post that goes on above the seat are one. The ontology then finds a piece that is nothing it knows, or a part fits
 * its box badly. So the cut is a hypothesis, as likely as
 *
 *     the mean over the surface of  fit x fuzzy membership in the name, 0 without a name
 *     x 0.8 where the object is nothing that is known, x 0.98 where it breaks a rule      - 0.003 a region
 *
 * and edits are tried around what is suspicious, each judged by asking the whole expert system again:
 *
 *     join    a region without a name, or a stump that hardly is what it is called, and a neighbour, where their common
 *             box is hardly larger than both boxes
 *     recut   a badly fitting part, or one without a name that is much of the object, along the pieces of a second,
 *             finer cut (find_parts without joining), and then join the pieces to each other and to the neighbours as
 *             long as that is likelier
 *
 * What has no name does not join a part half as large under the name of that: a handle does not swallow the mug.
 * The best edit is taken as long as one is likelier by a margin. A rule that is broken counts for little, so that a
 * defect is reported rather than cut away: no edit may pay for it with a bad fit.
 *
 * Nothing is tried where every region has a name and fits well. Cost: a join is one box and one questioning of the
 * regions, which keep their measurements, about a millisecond; at most 160 of them. A recut costs find_parts once more,
 * whatever the number of parts. Deterministic: likelihoods are compared in the order of the regions.
 *
 * Coarse meshes are not cut again: their borders are edges that someone drew. Objects with colours stay as they are:
 * find_parts does not see what colour parted. Scenes have too many regions.
 *
 * Left: membership in several regions at once, and moving triangles one by one between names (a labelling by graph cut
 * over triangles with the ontology's constraints as its unary terms). Borders are drawn at creases already by
 * find_parts (settle.cpp), and parts must stay parts. */

#include "expert/final_labelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/spelling.h"
#include "shape/part_box.h"
#include "shape/refine.h"

namespace partonomy {
namespace {

constexpr double unrecognised = 0.8, forbidden = 0.98, each_region = 0.003;
constexpr double bad_fit = 0.8, worse_fit = 0.9;  // of a part worth cutting again; in an object that is not recognised
constexpr double unlikely = 0.6;                  // quality of a region that may join another one
constexpr double least_part = 0.02, least_piece = 0.002;  // shares of the surface: of a part to cut, of its pieces
constexpr double much_of_it = 0.1;                        // of the surface, in one part
constexpr double along = 0.1;                             // of a region's border: a neighbour
constexpr double roomy = 1.25, very_roomy = 3;            // common box over both boxes, at most; of an unnamed stump
constexpr double stump = 0.02;                            // share of the surface, at most
constexpr double swallowed = 2;                           // times as large as what would give it its name
constexpr double join_margin = 0.2;                       // of the joining region's share of the surface
constexpr double recut_margin = 0.01;
constexpr std::size_t most_regions = 64, most_suspicious = 16, most_pieces = 100;
constexpr int most_trials = 160, most_recuts = 4;

using Shared = std::shared_ptr<const MeasuredRegion>;

double area_of(const Shared& region) { return region->measurements.area; }

struct State {
    Cut cut;
    Verdict verdict;
    double likelihood = 0;
};

class Search {
public:
    Search(const Object& object, const std::function<Verdict(const Cut&)>& judge, int threads)
        : object_(object), judge_(judge), threads_(threads), adjacency_(build_adjacency(object.mesh)) {
        for (const double area : object.geometry.areas) surface_ += area;
    }

    [[nodiscard]] State state_of(Cut cut, Verdict verdict) const {
        State state{std::move(cut), std::move(verdict), 0};
        double good = 0;
        for (std::size_t i = 0; i < state.cut.size(); ++i) good += share(state.cut[i]) * quality(state, i);
        if (!state.verdict.is_recognised) good *= unrecognised;
        if (!state.verdict.is_consistent) good *= forbidden;
        state.likelihood = good - each_region * static_cast<double>(state.cut.size());
        return state;
    }

    /// Joins suspicious regions to neighbours as long as that is likelier. `fresh`: count as suspicious, whatever they
    /// are called.
    State join_all(State state, std::set<const MeasuredRegion*> fresh, std::vector<Edit>& edits) {
        while (trials < most_trials) {
            std::optional<State> best;
            Edit edit;
            double most = 0;
            const Borders borders = borders_of(state.cut);
            std::set<std::pair<std::size_t, std::size_t>> tried;
            for (const std::size_t i : suspicious(state, fresh))
                for (std::size_t j = 0; j < state.cut.size(); ++j) {
                    if (borders.between(i, j) < along * borders.around[i] || !tried.insert(std::minmax(i, j)).second)
                        continue;
                    const bool is_stump = state.verdict.regions[i].name.empty() && share(state.cut[i]) < stump;
                    const Joined& whole = join(state.cut[i], state.cut[j]);
                    if (whole.room > (is_stump ? very_roomy : roomy)) continue;
                    const bool is_fresh = fresh.contains(state.cut[i].get());
                    const double margin = is_fresh ? 0 : join_margin * share(state.cut[i]);
                    if (best_gain(state, i, j, whole.region->part.fit) - margin <= most) continue;
                    State next = judged(replaced(state.cut, {i, j}, {whole.region}));
                    const double gain = next.likelihood - state.likelihood - margin;
                    if (gain <= most || (!is_fresh && swallows(state, j, i, next, whole.region))) continue;
                    most = gain;
                    const std::string& name = state.verdict.regions[i].name;
                    edit = {
                        fmt::format("took in {} ({:.1f} % of the surface)",
                                    name.empty() ? "a piece without a name" : "a piece that was " + with_article(name),
                                    100 * share(state.cut[i])),
                        state.cut[j]->part.region.triangles.front()};
                    if (is_fresh || fresh.contains(state.cut[j].get())) fresh.insert(whole.region.get());
                    best = std::move(next);
                }
            if (!best) break;
            state = std::move(*best);
            edits.push_back(std::move(edit));
        }
        return state;
    }

    /// Cuts parts that fit badly along finer pieces, the worst first.
    State recut_all(State state, std::vector<Edit>& edits) {
        const double size = compute_bounds(object_.mesh).diagonal();
        if (std::isfinite(refinement_length(object_.mesh, size))) return state;  // borders are edges that someone drew
        std::set<const MeasuredRegion*> done;
        for (int recut = 0; recut < most_recuts && trials < most_trials; ++recut) {
            std::size_t worst = state.cut.size();
            double most = 0;
            for (std::size_t i = 0; i < state.cut.size(); ++i) {
                const double loss = share(state.cut[i]) * (1 - state.cut[i]->part.fit);
                if (done.contains(state.cut[i].get()) || state.cut[i]->part.fit >= fit_limit(state, i) ||
                    share(state.cut[i]) < least_part || loss <= most)
                    continue;
                most = loss;
                worst = i;
            }
            if (worst == state.cut.size()) break;
            const Shared part = state.cut[worst];
            done.insert(part.get());
            const Cut pieces = pieces_of(part);
            if (pieces.size() < 2) continue;
            std::set<const MeasuredRegion*> fresh;
            for (const Shared& piece : pieces) fresh.insert(piece.get());
            std::vector<Edit> joins;
            State next = join_all(judged(replaced(state.cut, {worst}, pieces)), fresh, joins);
            if (next.likelihood < state.likelihood + recut_margin) continue;
            const std::string& name = state.verdict.regions[worst].name;
            edits.push_back({fmt::format("comes of a part that fitted its box badly ({}, {:.2f}) and was cut again",
                                         name.empty() ? "without a name" : with_article(name), part->part.fit),
                             part->part.region.triangles.front()});
            for (const Shared& piece : pieces) done.insert(piece.get());
            state = std::move(next);
        }
        return state;
    }

    int trials = 0;

private:
    struct Borders {
        std::map<std::pair<std::size_t, std::size_t>, double> lengths;
        std::vector<double> around;
        [[nodiscard]] double between(std::size_t i, std::size_t j) const {
            const auto found = lengths.find({i, j});
            return found == lengths.end() ? -1 : found->second;
        }
    };

    [[nodiscard]] double share(const Shared& region) const { return area_of(region) / surface_; }

    /// The fit below which a part is worth cutting again. What is much of the object and nothing that is known is worth
    /// it however well it fits: a bottle whose body and neck are one stick, a lens with its rim.
    [[nodiscard]] double fit_limit(const State& state, std::size_t i) const {
        if (state.verdict.regions[i].name.empty() && share(state.cut[i]) > much_of_it) return 1;
        return state.verdict.is_recognised ? bad_fit : worse_fit;
    }

    [[nodiscard]] static double quality(const State& state, std::size_t i) {
        const Verdict::Named& named = state.verdict.regions[i];
        return named.name.empty() ? 0 : state.cut[i]->part.fit * named.fuzzy;
    }

    /// Whether a much larger region without a name would have the name of region `by` after the join.
    [[nodiscard]] bool swallows(const State& before, std::size_t by, std::size_t what, const State& after,
                                const Shared& whole) const {
        const std::string& name = before.verdict.regions[by].name;
        if (name.empty() || !before.verdict.regions[what].name.empty() ||
            share(before.cut[what]) < swallowed * share(before.cut[by]))
            return false;
        const auto place = std::ranges::find(after.cut, whole) - after.cut.begin();
        return after.verdict.regions[static_cast<std::size_t>(place)].name == name;
    }

    /// What a join would gain were the whole sure of its name and the others' names the same; no limit where the
    /// object's class or a rule is at stake.
    [[nodiscard]] double best_gain(const State& state, std::size_t i, std::size_t j, double fit) const {
        if (!state.verdict.is_recognised || !state.verdict.is_consistent) return 1;
        return share(state.cut[i]) * (fit - quality(state, i)) + share(state.cut[j]) * (fit - quality(state, j)) +
               each_region;
    }

    /// Regions that may belong to another one, the largest loss first.
    [[nodiscard]] std::vector<std::size_t> suspicious(const State& state,
                                                      const std::set<const MeasuredRegion*>& fresh) const {
        std::vector<std::pair<double, std::size_t>> found;
        for (std::size_t i = 0; i < state.cut.size(); ++i)
            if (fresh.contains(state.cut[i].get()) || state.verdict.regions[i].name.empty() ||
                (quality(state, i) < unlikely && share(state.cut[i]) < stump))
                found.emplace_back(-share(state.cut[i]) * (1 - quality(state, i)), i);
        std::ranges::stable_sort(found, {}, &std::pair<double, std::size_t>::first);
        if (found.size() > most_suspicious) found.resize(most_suspicious);
        std::vector<std::size_t> regions;
        for (const auto& [loss, i] : found) regions.push_back(i);
        return regions;
    }

    State judged(Cut cut) {
        ++trials;
        Verdict verdict = judge_(cut);
        return state_of(std::move(cut), std::move(verdict));
    }

    static Cut replaced(const Cut& cut, const std::set<std::size_t>& out, const Cut& in) {
        Cut result;
        for (std::size_t i = 0; i < cut.size(); ++i)
            if (!out.contains(i)) result.push_back(cut[i]);
        result.insert(result.end(), in.begin(), in.end());
        std::ranges::sort(result, {}, [](const Shared& region) { return region->part.region.triangles.front(); });
        return result;
    }

    [[nodiscard]] std::vector<std::int32_t> owners(const Cut& cut) const {
        std::vector<std::int32_t> owner(object_.mesh.triangles.size(), -1);
        for (std::size_t i = 0; i < cut.size(); ++i)
            for (const std::int32_t t : cut[i]->part.region.triangles)
                owner[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(i);
        return owner;
    }

    [[nodiscard]] double edge_length(std::size_t triangle, std::size_t e) const {
        const auto& corners = object_.mesh.triangles[triangle];
        return (object_.mesh.positions[static_cast<std::size_t>(corners[(e + 1) % 3])] -
                object_.mesh.positions[static_cast<std::size_t>(corners[e])])
            .norm();
    }

    [[nodiscard]] Borders borders_of(const Cut& cut) const {
        const std::vector<std::int32_t> owner = owners(cut);
        Borders borders{{}, std::vector<double>(cut.size(), 0.0)};
        for (std::size_t t = 0; t < owner.size(); ++t)
            for (std::size_t e = 0; owner[t] >= 0 && e < 3; ++e) {
                const std::int32_t n = adjacency_.neighbours[t][e];
                if (n < 0 || owner[static_cast<std::size_t>(n)] == owner[t]) continue;
                const double length = edge_length(t, e);
                borders.around[static_cast<std::size_t>(owner[t])] += length;
                if (owner[static_cast<std::size_t>(n)] < 0) continue;
                borders.lengths[{static_cast<std::size_t>(owner[t]),
                                 static_cast<std::size_t>(owner[static_cast<std::size_t>(n)])}] += length;
            }
        return borders;
    }

    [[nodiscard]] Shared measured(std::vector<std::int32_t> triangles) const {
        auto region = std::make_shared<MeasuredRegion>();
        PartBox box = measure_part(object_.mesh, object_.geometry, triangles, object_.is_noisy, threads_);
        region->part = {{std::move(triangles), std::move(box.memberships)}, box.box, box.fit, object_.is_noisy};
        region->measurements = measure_region(object_, region->part);
        return region;
    }

    /// Both in one, and the common box over both boxes.
    struct Joined {
        Shared region;
        double room = 0;
    };
    const Joined& join(const Shared& a, const Shared& b) {
        const auto [known, is_new] = joined_.try_emplace({a, b});
        if (!is_new) return known->second;
        std::vector<std::int32_t> triangles;
        std::ranges::merge(a->part.region.triangles, b->part.region.triangles, std::back_inserter(triangles));
        const Shared whole = measured(std::move(triangles));
        const auto volume = [](const Shared& region) { return region->part.box.lengths.prod(); };
        known->second = {whole, volume(whole) / (volume(a) + volume(b))};
        return known->second;
    }

    /// A part along the borders of the finer cut; what is too small goes to the piece that it borders on most.
    Cut pieces_of(const Shared& part) {
        if (finer_.empty()) {
            finer_.assign(object_.mesh.triangles.size(), -1);
            std::int32_t number = 0;
            for (const PartRegion& piece : find_parts(
                     object_.mesh,
                     {.up = object_.placement.up, .threads = threads_, .tree = object_.tree, .is_joined = false})) {
                for (const std::int32_t t : piece.region.triangles) finer_[static_cast<std::size_t>(t)] = number;
                ++number;
            }
        }
        const std::vector<std::int32_t>& triangles = part->part.region.triangles;
        std::vector<std::int32_t> piece_of(object_.mesh.triangles.size(), -2);  // -2: elsewhere, -1: not yet
        for (const std::int32_t t : triangles) piece_of[static_cast<std::size_t>(t)] = -1;
        std::vector<double> areas;
        std::vector<std::int32_t> queue;
        for (const std::int32_t first : triangles) {
            if (piece_of[static_cast<std::size_t>(first)] != -1) continue;
            const auto number = static_cast<std::int32_t>(areas.size());
            areas.push_back(0);
            queue.assign(1, first);
            piece_of[static_cast<std::size_t>(first)] = number;
            for (std::size_t at = 0; at < queue.size(); ++at) {
                areas.back() += object_.geometry.areas[static_cast<std::size_t>(queue[at])];
                for (const std::int32_t n : adjacency_.neighbours[static_cast<std::size_t>(queue[at])])
                    if (n >= 0 && piece_of[static_cast<std::size_t>(n)] == -1 &&
                        finer_[static_cast<std::size_t>(n)] == finer_[static_cast<std::size_t>(first)]) {
                        piece_of[static_cast<std::size_t>(n)] = number;
                        queue.push_back(n);
                    }
            }
        }
        if (areas.size() > most_pieces) return {};
        give_away_small(triangles, piece_of, areas);
        std::map<std::int32_t, std::vector<std::int32_t>> pieces;
        for (const std::int32_t t : triangles) pieces[piece_of[static_cast<std::size_t>(t)]].push_back(t);
        Cut cut;
        if (pieces.size() > 1)
            for (auto& [number, of_piece] : pieces) cut.push_back(measured(std::move(of_piece)));
        return cut;
    }

    void give_away_small(const std::vector<std::int32_t>& triangles, std::vector<std::int32_t>& piece_of,
                         std::vector<double>& areas) const {
        while (true) {
            std::map<std::pair<std::int32_t, std::int32_t>, double> lengths;
            for (const std::int32_t t : triangles)
                for (std::size_t e = 0; e < 3; ++e) {
                    const std::int32_t n = adjacency_.neighbours[static_cast<std::size_t>(t)][e];
                    if (n < 0 || piece_of[static_cast<std::size_t>(n)] < 0) continue;
                    const std::int32_t own = piece_of[static_cast<std::size_t>(t)];
                    const std::int32_t other = piece_of[static_cast<std::size_t>(n)];
                    if (own != other && areas[static_cast<std::size_t>(own)] < least_piece * surface_)
                        lengths[{own, other}] += edge_length(static_cast<std::size_t>(t), e);
                }
            if (lengths.empty()) return;
            const std::int32_t smallest = std::ranges::min_element(lengths, {}, [&](const auto& each) {
                                              return areas[static_cast<std::size_t>(each.first.first)];
                                          })->first.first;
            std::int32_t into = -1;
            double longest = 0;
            for (const auto& [pair, length] : lengths)
                if (pair.first == smallest && length > longest) {
                    longest = length;
                    into = pair.second;
                }
            if (into < 0) return;
            for (const std::int32_t t : triangles)
                if (piece_of[static_cast<std::size_t>(t)] == smallest) piece_of[static_cast<std::size_t>(t)] = into;
            areas[static_cast<std::size_t>(into)] += areas[static_cast<std::size_t>(smallest)];
            areas[static_cast<std::size_t>(smallest)] = 0;
        }
    }

    const Object& object_;
    const std::function<Verdict(const Cut&)>& judge_;
    int threads_;
    Adjacency adjacency_;
    double surface_ = 0;
    std::map<std::pair<Shared, Shared>, Joined> joined_;
    std::vector<std::int32_t> finer_;  ///< per triangle the piece of the finer cut, once it was made
};

/// Whether nothing asks for another cut.
bool is_fine(const Cut& cut, const Verdict& verdict, double surface) {
    const double limit = verdict.is_recognised ? bad_fit : worse_fit;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        const double fit = cut[i]->part.fit;
        if (verdict.regions[i].name.empty() || fit * verdict.regions[i].fuzzy < unlikely) return false;
        if (fit < limit && area_of(cut[i]) >= least_part * surface) return false;
    }
    return true;
}

}  // namespace

Cut cut_of(const Object& object) {
    Cut cut;
    for (const PartRegion& part : object.candidates) {
        auto region = std::make_shared<MeasuredRegion>();
        region->part = part;
        region->measurements = measure_region(object, region->part);
        cut.push_back(std::move(region));
    }
    return cut;
}

std::optional<FinalLabelling> find_final_labelling(const Object& object, const Cut& cut, const Verdict& first,
                                                   const std::function<Verdict(const Cut&)>& judge, int threads) {
    double surface = 0;
    for (const double area : object.geometry.areas) surface += area;
    if (cut.empty() || cut.size() > most_regions || object.is_scene || object.appearance ||
        is_fine(cut, first, surface))
        return std::nullopt;
    Search search(object, judge, threads);
    FinalLabelling result;
    State state = search.join_all(search.state_of(cut, first), {}, result.edits);
    state = search.recut_all(std::move(state), result.edits);
    if (result.edits.empty()) return std::nullopt;
    result.cut = std::move(state.cut);
    result.trials = search.trials;
    return result;
}

}  // namespace partonomy
