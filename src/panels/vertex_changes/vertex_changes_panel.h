// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "models/attribution_model.h"
#include "models/vertex_changes_model.h"

class QAction;
class QMimeData;
class QTableView;

namespace Ui {
class VertexChanges;
}

namespace hitscope {

/// The dock "Vertex changes": a row a changed vertex, sorted by a click on a column's title and filtered;
/// beneath, or beside where there is more width than height, what each hit did to the picked one. Selecting
/// rows selects vertices in the viewport, and the other way round.
class VertexChangesPanel : public QWidget {
    Q_OBJECT
public:
    /// All outlive the panel.
    VertexChangesPanel(Session& session, VertexChangesModel& changes, AttributionModel& attribution,
                       QWidget* parent = nullptr);
    ~VertexChangesPanel() override;

    static constexpr int kMostCopied = 100'000;  ///< rows: more are for a file

Q_SIGNALS:
    void vertexWanted(const hitscope::VertexRef& vertex);  ///< someone wants to see it
    void failed(const hitscope::Error& error);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void setUpTables();
    void setUpFilter();
    void makeActions();
    void connectAll();
    void choose(int first, int last, int at, VertexSelection::Combine combine);
    void chooseHit(const QModelIndex& index);
    void hover(std::optional<int> row);
    void showPicked();
    void updateSummary();
    void updateAttribution();
    void copy();
    void save();
    [[nodiscard]] QMimeData* dragged() const;
    /// The selected ones that have a row, in the order of the rows; all rows if none has.
    [[nodiscard]] std::vector<std::uint32_t> copied() const;

    Session& m_session;
    VertexChangesModel& m_changes;
    AttributionModel& m_attribution;
    std::unique_ptr<Ui::VertexChanges> m_ui;
    QAction* m_copy = nullptr;
    QAction* m_save = nullptr;
    bool m_choosing = false;  ///< the table is where the selection changes
};

}  // namespace hitscope
