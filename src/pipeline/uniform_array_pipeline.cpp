// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/uniform_array_pipeline.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

namespace hitscope {
namespace {

/// Never the same twice, so that a program tells whose arrays it has, and in which state.
std::uint64_t nextStamp() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

int limit(const std::optional<int>& asIf, GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return asIf.value_or(value);
}

Result<CapturePass> passFor(const HitRoom& room, const gl::Defines& deformDefines) {
    gl::Defines defines = hitArrayDefines(room);
    defines.insert(defines.end(), deformDefines.begin(), deformDefines.end());
    return CapturePass::create(std::move(defines));
}

/// Where to try to keep hits, the best first. OpenGL leaves it to the driver how densely arrays are packed.
std::vector<HitRoom> roomsToTry(const PipelineOptions& options) {
    const std::size_t uniforms =
        hitsInUniforms(limit(options.vertexUniformComponents, GL_MAX_VERTEX_UNIFORM_COMPONENTS));
    const std::size_t block = hitsInBlock(limit(options.uniformBlockBytes, GL_MAX_UNIFORM_BLOCK_SIZE));
    std::vector<HitRoom> rooms;
    if (uniforms >= kMostArrayHits) {
        rooms.push_back({HitStorage::Floats, uniforms});
    }
    if (block > uniforms) {
        rooms.push_back({HitStorage::UniformBlock, block});
    }
    rooms.push_back({HitStorage::Floats, uniforms});
    rooms.push_back({HitStorage::Vectors, uniforms});
    return rooms;
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

Result<std::unique_ptr<DeformationPipeline>> UniformArrayPipeline::create(PipelineKind kind,
                                                                          const PipelineOptions& options) {
    std::optional<Error> refused;
    for (const HitRoom& room : roomsToTry(options)) {
        // The capturing program has arrays that take up the other programs' share as well: if it links, they
        // will.
        const bool isBlock = room.storage == HitStorage::UniformBlock;
        const HitRoom tried{room.storage, room.hits + (isBlock ? 0 : kOtherUniformsInHits)};
        Result<CapturePass> pass = passFor(tried, options.deformDefines);
        if (pass) {
            return std::unique_ptr<DeformationPipeline>(
                new UniformArrayPipeline(kind, std::move(pass).value(), room, options.deformDefines));
        }
        refused = pass.error();
    }
    return *refused;
}

UniformArrayPipeline::UniformArrayPipeline(PipelineKind kind, CapturePass pass, const HitRoom& room,
                                           gl::Defines defines)
    : m_kind(kind), m_pass(std::move(pass)), m_room(room), m_deformDefines(std::move(defines)) {}

CapacityReport UniformArrayPipeline::capacity() const {
    CapacityReport report{m_room.hits, isCulled(), 0, m_dropped, m_room.hits < kMostArrayHits};
    for (const auto& [id, window] : m_windows) {
        report.used = std::max(report.used, window.hits().size());
    }
    return report;
}

void UniformArrayPipeline::addTarget(TargetId target, TargetBuffers& buffers) {
    m_targets.erase(target);
    m_targets.emplace(target, TargetState(buffers));
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
    return m_windows.try_emplace(isCulled() ? target : TargetId{}, m_room.hits).first->second;
}

/// Only hits that are enabled and whose target is there take up room.
void UniformArrayPipeline::push(std::size_t index, std::vector<KeptHit>& dropped) {
    const auto& [unset, serial, hit] = m_history[index];
    if (hit.enabled && m_targets.contains(hit.target)) {
        windowOf(hit.target).push({index, serial, hit}, dropped);
    }
}

/// Takes the hits [firstHit, ...) of the history, which come after all those before.
void UniformArrayPipeline::append(std::size_t firstHit) {
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
    ++target.epoch;
    std::vector<std::uint32_t> concerned;
    for (const Hit& hit : changed) {
        target.reach.everReached(hit, concerned);
    }
    std::sort(concerned.begin(), concerned.end());
    concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
    target.unread.add(target.reach.rangesOf(concerned));
    target.reach.restart(concerned);
    std::vector<std::uint32_t> reached;
    for (const KeptHit& hit : target.kept) {
        reached.clear();
        target.reach.advanceWithin(concerned, hit.hit, reached);
    }
}

/// A target's hits stand together, in their order; targets do not influence one another. As the paper has it
/// all fit in one page.
void UniformArrayPipeline::fillPages() {
    m_pages.clear();
    m_pages.push_back({HitArrays(m_room), nextStamp()});
    for (auto& [id, target] : m_targets) {
        std::vector<Hit> hits = hitsOf(target.kept);
        if (isCulled()) {
            std::erase_if(hits, [&reach = target.reach](const Hit& hit) { return !reach.mayEverReach(hit); });
        }
        if (m_pages.back().arrays.left() < hits.size()) {
            m_pages.push_back({HitArrays(m_room), nextStamp()});
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
        m_pass.run(
            *target.buffers, runs,
            [&](const gl::Program& program) {
                show(m_pages[target.page], program);
                program.set("u_firstHit", static_cast<int>(target.firstHit));
                program.set("u_lastHit", static_cast<int>(target.lastHit));
            },
            [&](std::span<const VertexRange> ranges) {
                m_readBack.request({{.target = entry.first,
                                     .buffer = m_pass.scratch(),
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
        if (known == m_targets.end()) {
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
    gl::Defines defines = hitArrayDefines(m_room);
    if (isCulled()) {
        defines.emplace_back("HITSCOPE_OWN_HITS_ONLY", "1");
    }
    defines.insert(defines.end(), m_deformDefines.begin(), m_deformDefines.end());
    return defines;
}

void UniformArrayPipeline::prepareDraw(const gl::Program& program, TargetId target) {
    const auto known = m_targets.find(target);
    show(m_pages.at(known == m_targets.end() ? 0 : known->second.page), program);
    program.set("u_firstHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.firstHit));
    program.set("u_lastHit", known == m_targets.end() ? 0 : static_cast<int>(known->second.lastHit));
}

}  // namespace hitscope
