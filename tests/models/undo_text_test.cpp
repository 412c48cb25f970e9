// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_text.h"
#include "support/test_program.h"

#include <QTest>

namespace hitscope::undo_text_test {

class UndoTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void namesTheStep_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("hits");
        QTest::addColumn<int>("hit");
        QTest::addColumn<int>("part");
        QTest::addColumn<QString>("text");
        const auto row = [](SessionUndo::Kind kind, int hits, const char* text, int hit = 0,
                            UndoPart part = UndoPart::None) {
            QTest::newRow(text) << static_cast<int>(kind) << hits << hit << static_cast<int>(part)
                                << QString::fromLatin1(text);
        };
        row(SessionUndo::Kind::Hit, 1, "Hit");
        row(SessionUndo::Kind::Hit, 2, "2 Hits");
        row(SessionUndo::Kind::Remove, 1, "Remove Hit");
        row(SessionUndo::Kind::Remove, 3, "Remove 3 Hits");
        row(SessionUndo::Kind::Clear, 1000, "Clear 1,000 Hits");
        row(SessionUndo::Kind::Move, 1, "Reorder Hit");
        row(SessionUndo::Kind::Enable, 2, "Enable 2 Hits");
        row(SessionUndo::Kind::Disable, 1, "Disable Hit");
        row(SessionUndo::Kind::EditHit, 1, "Edit Hit 1,204", 1204);
        row(SessionUndo::Kind::EditHit, 1, "Power of Hit 3", 3, UndoPart::Power);
        row(SessionUndo::Kind::EditHit, 2, "Max Distance of 2 Hits", 0, UndoPart::MaxDistance);
        row(SessionUndo::Kind::Constants, 1, "Max Magnitude for Next Hit", 0, UndoPart::MaxMagnitude);
        row(SessionUndo::Kind::Constants, 1, "Constants for Next Hit", 0, UndoPart::PressRadius);
        row(SessionUndo::Kind::CuttingPlane, 1, "Cutting Plane");
        row(SessionUndo::Kind::CuttingPlane, 1, "Cutting Plane Off", 0, UndoPart::CutOff);
        row(SessionUndo::Kind::CuttingPlane, 1, "Offset of Cutting Plane", 0, UndoPart::CutOffset);
        row(SessionUndo::Kind::HitConstants, 1, "Constants of Hit 3", 3);
        row(SessionUndo::Kind::HitConstants, 12, "Constants of 12 Hits");
        row(SessionUndo::Kind::Constants, 1, "Constants for Next Hit");
        row(SessionUndo::Kind::Lights, 1, "Lights");
        row(SessionUndo::Kind::AddTarget, 1, "Add Target");
        row(SessionUndo::Kind::ReloadMesh, 1, "Reload Mesh");
        row(SessionUndo::Kind::ReloadMesh, 2, "Reload Meshes of 2 Targets");
        row(SessionUndo::Kind::RemoveTarget, 4, "Remove 4 Targets");
        row(SessionUndo::Kind::RenameTarget, 1, "Rename Target");
    }
    void namesTheStep() {
        QFETCH(int, kind);
        QFETCH(int, hits);
        QFETCH(int, hit);
        QFETCH(int, part);
        QFETCH(QString, text);
        QCOMPARE(undoText({static_cast<SessionUndo::Kind>(kind), static_cast<std::size_t>(hits),
                           static_cast<std::size_t>(hit), static_cast<UndoPart>(part)}),
                 text);
    }
};

HITSCOPE_TEST(UndoTextTest, QCoreApplication)

}  // namespace hitscope::undo_text_test

#include "undo_text_test.moc"
