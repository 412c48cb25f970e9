// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QTableView>
#include <QTest>
#include <memory>

#include "panels/scene/scene_panel.h"
#include "widgets/window_support.h"

namespace hitscope {

/// The Scene panel over the paper's scene, in a window of its own, for tests that click and type.
class ScenePanelRig : public QObject {
protected:
    void setUp();
    [[nodiscard]] QPoint place(int row, int column) const {
        return m_table->visualRect(m_model->index(row, column)).center();
    }
    void click(int row, int column = SceneModel::NameColumn, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, keys, place(row, column));
    }
    [[nodiscard]] TargetId id(std::size_t index) const { return m_session->targets()[index]->id; }
    template <class Widget>
    [[nodiscard]] Widget& child(const char* name) const {
        return *m_panel->findChild<Widget*>(QString::fromLatin1(name));
    }
    void typeInto(const char* field, const QString& text) {
        auto& box = child<QDoubleSpinBox>(field);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneModel> m_model;
    std::unique_ptr<ScenePanel> m_panel;
    QTableView* m_table = nullptr;
};

inline void ScenePanelRig::setUp() {
    m_panel.reset();
    m_model.reset();
    m_session = std::make_unique<Session>();
    loadPaperRow(*m_session, kDefaultPaperRow);
    m_model = std::make_unique<SceneModel>(*m_session);
    m_panel = std::make_unique<ScenePanel>(*m_session, *m_model);
    m_table = m_panel->findChild<QTableView*>();
    m_panel->resize(350, 480);
    m_panel->show();
    makeActive(*m_panel);
    m_table->setFocus();
}

}  // namespace hitscope
