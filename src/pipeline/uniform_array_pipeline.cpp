// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/uniform_array_pipeline.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "deform/hit_bounds.h"
#include "pipeline/hit_rooms.h"

namespace hitscope {
namespace {

/// Never the same twice, so that a program tells whose arrays it has, and in which state.
std::uint64_t nextStamp() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

Result<CapturePass> passFor(const HitRoom& room, const gl::Defines& deformDefines) {
    gl::Defines defines = hitArrayDefines(room);
    defines.insert(defines.end(), deformDefines.begin(), deformDefines.end());
    return CapturePass::create(std::move(defines));
}

std::vector<Hit> hitsOf(std::span<const KeptHit> kept) {
    std::vector<Hit> hits;
    hits.reserve(kept.size());
    for (const KeptHit& hit : kept) {
        hits.push_back(hit.hit);
    }
    return hits;
}

/// The hits that only one of the two lists has.
std::vector<Hit> difference(std::span<const KeptHit> a, std::span<const KeptHit> b) {
    std::vector<Hit> hits;
    for (const auto& [mine, others] : {std::pair(a, b), std::pair(b, a)}) {
        std::set<std::uint64_t> serials;
        for (const KeptHit& hit : others) {
            serials.insert(hit.serial);
        }
        for (const KeptHit& hit : mine) {
            if (!serials.contains(hit.serial)) {
                hits.push_back(hit.hit);
            }
        }
    }
    return hits;
}

}  // namespace

/// In the first of them that the driver takes.
Result<UniformArrayPipeline::Way> UniformArrayPipeline::wayIn(std::span<const HitRoom> rooms,
                                                              const PipelineOptions& options) {
    std::optional<Error> refused;
    for (const HitRoom& room : rooms) {
        // The capturing program has arrays that take up the other programs' share as well: if it links, they
        // will.
        const bool isBlock = room.storage == HitStorage::UniformBlock;
        const std::size_t others = room.hasForms() ? kOtherUniformsInForms : kOtherUniformsInHits;
        const HitRoom tried{room.storage, room.hits + (isBlock ? 0 : others), room.curves};
        Result<CapturePass> pass = passFor(tried, options.deformDefines);
        if (pass) {
            return Way{room, std::move(pass).value()};
        }
        refused = pass.error();
    }
    return *refused;
}

Result<std::unique_ptr<DeformationPipeline>> UniformArrayPipeline::create(PipelineKind kind,
                                                                          const PipelineOptions& options) {
    Result<Way> way = wayIn(roomsToTry(options), options);
    if (!way) {
        return way.error();
    }
    return std::unique_ptr<DeformationPipeline>(
        new UniformArrayPipeline(kind, std::move(way).value(), options));
}

UniformArrayPipeline::UniformArrayPipeline(PipelineKind kind, Way way, PipelineOptions options)
    : m_kind(kind), m_options(std::move(options)), m_paper(std::move(way)) {}

CapacityReport UniformArrayPipeline::capacity() const {
    const std::size_t hits = way().room.hits;
    CapacityReport report{hits, isCulled(), 0, m_dropped, hits < kMostArrayHits};
    for (const auto& [id, window] : m_windows) {
        report.used = std::max(report.used, window.hits().size());
    }
    return report;
}

/// Only hits that are enabled and whose target is there take up room.
bool UniformArrayPipeline::isKept(const Hit& hit) const {
    return hit.enabled && m_targets.contains(hit.target);
}

/// Whether the paper's function alone is not enough for the hits [firstHit, ...).
bool UniformArrayPipeline::needsForms(std::size_t firstHit) const {
    return std::any_of(
        m_history.begin() + static_cast<std::ptrdiff_t>(firstHit), m_history.end(),
        [this](const KeptHit& kept) { return !kept.hit.form.hasPaperFunction() && isKept(kept.hit); });
}

/// Programs of their own, so that the others cost no more than they did. Where the driver takes none, hits of
/// other forms are dropped.
void UniformArrayPipeline::takeUpForms() {
    if (!std::exchange(m_triedForms, true)) {
        if (Result<Way> way = wayIn(formRoomsToTry(m_options), m_options)) {
            m_forms = std::move(way).value();
        }
    }
    m_usesForms = m_forms.has_value();
}

void UniformArrayPipeline::addTarget(TargetId target, TargetBuffers& buffers) {
    m_targets.erase(target);
    m_targets.emplace(target, TargetState(buffers, ++m_lastEpoch));
    refill();
}

void UniformArrayPipeline::removeTarget(TargetId target) {
    if (m_targets.erase(target) > 0) {
        refill();
    }
}

void UniformArrayPipeline::startOver(std::span<const Hit> history) {
    m_history.clear();
    for (const Hit& hit : history) {
        m_history.push_back({0, m_nextSerial++, hit});
    }
    refill();
}

void UniformArrayPipeline::follow(const HistoryEdit& edit) {
    const auto first = m_history.begin() + static_cast<std::ptrdiff_t>(edit.first);
    const auto at = m_history.erase(first, first + static_cast<std::ptrdiff_t>(edit.before.size()));
    const bool isAppend = edit.before.empty() && at == m_history.end();
    std::vector<KeptHit> after;
    after.reserve(edit.after.size());
    for (const Hit& hit : edit.after) {
        after.push_back({0, m_nextSerial++, hit});
    }
    m_history.insert(at, after.begin(), after.end());
    if (isAppend) {
        append(edit.first);
    } else {
        refill();
    }
}

HitWindow& UniformArrayPipeline::windowOf(TargetId target) {
    const HitRoom& room = way().room;
    return m_windows.try_emplace(isCulled() ? target : TargetId{}, room.hits, room.curves).first->second;
}

void UniformArrayPipeline::push(std::size_t index, std::vector<KeptHit>& dropped) {
    const auto& [unset, serial, hit] = m_history[index];
    if (!isKept(hit)) {
        return;
    }
    if (!m_usesForms && !hit.form.hasPaperFunction()) {
        dropped.push_back({index, serial, hit});
        return;
    }
    windowOf(hit.target).push({index, serial, hit}, dropped);
}

/// Takes the hits [firstHit, ...) of the history, which come after all those before.
void UniformArrayPipeline::append(std::size_t firstHit) {
    if (!m_usesForms && needsForms(firstHit)) {
        refill();
        return;
    }
    std::vector<KeptHit> dropped;
    std::set<TargetId> concerned;
    for (std::size_t i = firstHit; i < m_history.size(); ++i) {
        push(i, dropped);
        concerned.insert(m_history[i].hit.target);
    }
    for (const KeptHit& hit : dropped) {
        m_dropped.insert(std::upper_bound(m_dropped.begin(), m_dropped.end(), hit.index), hit.index);
        concerned.insert(hit.hit.target);
    }
    keepWhatWindowsHold(concerned);
}

/// The history changed in its past: what the windows hold is found anew.
void UniformArrayPipeline::refill() {
    m_windows.clear();
    m_usesForms = false;
    if (needsForms(0)) {
        takeUpForms();
    }
    std::vector<KeptHit> dropped;
    for (std::size_t i = 0; i < m_history.size(); ++i) {
        push(i, dropped);
    }
    m_dropped.clear();
    for (const KeptHit& hit : dropped) {
        m_dropped.push_back(hit.index);
    }
    std::sort(m_dropped.begin(), m_dropped.end());
    std::set<TargetId> all;
    for (const auto& [id, target] : m_targets) {
        all.insert(id);
    }
    keepWhatWindowsHold(all);
}

void UniformArrayPipeline::keepWhatWindowsHold(const std::set<TargetId>& targets) {
    std::map<TargetId, std::vector<KeptHit>> kept;
    for (const auto& [id, window] : m_windows) {
        for (const KeptHit& hit : window.hits()) {
            if (targets.contains(hit.hit.target)) {
                kept[hit.hit.target].push_back(hit);
            }
        }
    }
    for (const TargetId id : targets) {
        const auto known = m_targets.find(id);
        if (known == m_targets.end()) {
            continue;
        }
        TargetState& target = known->second;
        const std::vector<KeptHit> before = std::exchange(target.kept, std::move(kept[id]));
        const bool isAppend =
            before.size() <= target.kept.size() &&
            std::equal(before.begin(), before.end(), target.kept.begin(),
                       [](const KeptHit& a, const KeptHit& b) { return a.serial == b.serial; });
        if (!isAppend) {
            reconsider(target, difference(before, target.kept));
            continue;
        }
        std::vector<std::uint32_t> reached;
        for (std::size_t i = before.size(); i < target.kept.size(); ++i) {
            reached.clear();
            target.reach.advance(target.kept[i].hit, reached);
            target.unread.add(target.reach.rangesOf(reached));
        }
    }
    fillPages();
}

/// Only clusters that a hit taken out or put in may have reached can come out otherwise.
void UniformArrayPipeline::reconsider(TargetState& target, std::span<const Hit> changed) {
    target.epoch = ++m_lastEpoch;
    const std::vector<std::uint32_t> concerned = target.reach.everReached(changed);
    target.unread.add(target.reach.rangesOf(concerned));
    target.reach.limitMoved(changedBy(changed, {}, hitsOf(target.kept)));
    target.reach.restart(concerned);
    std::vector<std::uint32_t> reached;
    for (const KeptHit& hit : target.kept) {
        reached.clear();
        target.reach.advanceWithin(concerned, hit.hit, reached);
    }
    target.reach.limitMoved(std::nullopt);
}

/// A target's hits stand together, in their order; targets do not influence one another. As the paper has it
/// all fit in one page.
void UniformArrayPipeline::fillPages() {
    m_pages.clear();
    m_pages.push_back({HitArrays(way().room), nextStamp()});
    for (auto& [id, target] : m_targets) {
        std::vector<Hit> hits = hitsOf(target.kept);
        if (isCulled()) {
            std::erase_if(hits, [&reach = target.reach](const Hit& hit) { return !reach.mayEverReach(hit); });
        }
        if (!m_pages.back().arrays.hasRoom(hits)) {
            m_pages.push_back({HitArrays(way().room), nextStamp()});
        }
        HitArrays& arrays = m_pages.back().arrays;
        target.page = m_pages.size() - 1;
        target.firstHit = arrays.size();
        for (const Hit& hit : hits) {
            arrays.add(hit);
        }
        target.lastHit = arrays.size();
    }
}

/// The program, in use, has that page's hits.
void UniformArrayPipeline::show(Page& page, const gl::Program& program) {
    if (program.contentStamp() != page.stamp) {
        page.arrays.upload(program);
        program.setContentStamp(page.stamp);
    }
    page.arrays.bind(program);
}

void UniformArrayPipeline::requestReadBack() {
    for (auto& entry : m_targets) {  // clang 14 cannot capture structured bindings
        TargetState& target = entry.second;
        if (target.unread.empty()) {
            continue;
        }
        std::vector<CaptureRun> runs;
        for (const VertexRange& range : target.unread.take()) {
            runs.push_back({range});
        }
        CapturePass& pass = way().pass;
        pass.run(
            *target.buffers, runs,
            [&](const gl::Program& program) {
                show(m_pages[target.page], program);
                program.set("u_firstHit", static_cast<int>(target.firstHit));
                program.set("u_lastHit", static_cast<int>(target.lastHit));
            },
            [&](std::span<const VertexRange> ranges) {
                m_readBack.request({{.target = entry.first,
                                     .buffer = pass.scratch(),
                                     .packed = true,
                                     .ranges = {ranges.begin(), ranges.end()},
                                     .moment = {m_nextSerial, target.epoch}}});
            });
    }
}

ReadBackQueue::Take UniformArrayPipeline::delivery(const ReadBackSink& sink) {
    return [this, &sink](const ReadBackQueue::Part& part, std::uint32_t first,
                         std::span<const DynamicVertex> vertices) {
        const auto known = m_targets.find(part.target);
        if (known == m_targets.end() || part.moment.epoch < known->second.born) {
            return;
        }
        TargetState& target = known->second;
        if (target.epoch == part.moment.epoch) {
            const auto later =
                std::partition_point(target.kept.begin(), target.kept.end(),
                                     [&part](const KeptHit& hit) { return hit.serial < part.moment.hits; });
            target.reach.place(first, vertices, hitsOf({later, target.kept.end()}));
        }
        sink(part.target, first, vertices);
    };
}

void UniformArrayPipeline::readBack(const ReadBackSink& sink) {
    requestReadBack();
    m_readBack.takeAll(delivery(sink));
}

void UniformArrayPipeline::pollReadBack(const ReadBackSink& sink) {
    requestReadBack();
    m_readBack.takeArrived(delivery(sink));
}

bool UniformArrayPipeline::isReadBackPending() const {
    return !m_readBack.empty() || std::any_of(m_targets.begin(), m_targets.end(),
                                              [](const auto& entry) { return !entry.second.unread.empty(); });
}

const ClusterReach* UniformArrayPipeline::reach(TargetId target) const {
    const auto found = m_targets.find(target);
    return found == m_targets.end() ? nullptr : &found->second.reach;
}

gl::Defines UniformArrayPipeline::drawDefines() const {
    gl::Defines defines = hitArrayDefines(way().room);
    if (isCulled()) {
        defines.emplace_back("HITSCOPE_OWN_HITS_ONLY", "1");
    }
    defines.insert(defines.end(), m_options.deformDefines.begin(), m_options.deformDefines.end());
    return defines;
}

void UniformArrayPipeline::prepareDraw(const gl::Program& program, TargetId target) {
    const auto known = m_targets.find(target);
    show(m_pages.at(known == m_targets.end() ? 0 : known->second.page), program);
    program.set("u_firstHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.firstHit));
    program.set("u_lastHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.lastHit));
}

}  // namespace hitscope
