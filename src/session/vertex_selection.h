// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/ids.h"

namespace hitscope {

class Session;

/// One vertex of a target, by its number in the file.
struct VertexRef {
    TargetId target;
    std::uint32_t vertex = 0;
    bool operator==(const VertexRef&) const = default;
};

/// Which vertices a person points at, has picked and has selected. There is one of it (Session::selection()):
/// viewport, tables and statistics show and change the same.
///
/// Vertices that do not exist are passed over; those of a target that goes are forgotten. Hits that come or
/// go leave it as it is.
class VertexSelection : public QObject {
    Q_OBJECT
public:
    explicit VertexSelection(Session& session);  ///< `session` owns it

    /// Under the cursor, here or in a table.
    [[nodiscard]] const std::optional<VertexRef>& hovered() const { return m_hovered; }
    void setHovered(const std::optional<VertexRef>& vertex);
    /// The one that attribution and measurements are about; selected or not.
    [[nodiscard]] const std::optional<VertexRef>& picked() const { return m_picked; }
    void setPicked(const std::optional<VertexRef>& vertex);

    /// The selected vertices of a target, ascending, each once.
    [[nodiscard]] std::span<const std::uint32_t> vertices(TargetId target) const;
    /// The targets that have some, ascending.
    [[nodiscard]] std::vector<TargetId> targets() const;
    [[nodiscard]] std::size_t count() const { return m_count; }  ///< on all targets
    [[nodiscard]] bool isSelected(const VertexRef& vertex) const;

    /// Grows with every change of what is selected.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }

    /// Replace: nothing else stays selected, on any target.
    enum class Combine : std::uint8_t { Replace, Add, Remove };
    /// In any order; repeated ones count once.
    void select(TargetId target, std::vector<std::uint32_t> vertices, Combine combine);
    /// Nothing is selected, picked or hovered.
    void clear();

Q_SIGNALS:
    void hoveredChanged();
    void pickedChanged();
    void selectionChanged();

private:
    [[nodiscard]] std::optional<VertexRef> existing(const std::optional<VertexRef>& vertex) const;
    void forget(TargetId target);
    void change(std::map<TargetId, std::vector<std::uint32_t>> selected);

    Session& m_session;
    std::optional<VertexRef> m_hovered;
    std::optional<VertexRef> m_picked;
    std::map<TargetId, std::vector<std::uint32_t>> m_selected;  ///< no empty ones
    std::size_t m_count = 0;
    std::uint64_t m_revision = 0;
};

}  // namespace hitscope
