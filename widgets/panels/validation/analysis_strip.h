/// \file
/// The part of the validation panel that tells what the background analysis of a mesh found, how far it is,
/// and lets it be stopped, started again, or followed by moving colliding branches apart.
#pragma once

#include "core/qt/session/jobs/analysis.h"
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace ramure {

class HistogramView;
class ShapeChecks;

class AnalysisStrip : public QWidget
{
    Q_OBJECT
public:
    /// \param analysis is not owned and must outlive the strip.
    explicit AnalysisStrip(Analysis* analysis, QWidget* parent = nullptr);

    /// Checks of nodes that are no trees. Not owned; must outlive the strip.
    void setShapes(ShapeChecks* shapes);
    /// \param isShape whether the shapes' checks tell of it.
    void setNode(NodeId node, bool isShape);

signals:
    /// The button beside the collisions was pressed.
    void separateRequested(ramure::NodeId tree);

private:
    void connectParts();
    void refresh();
    void showFindings(const MeshAnalysis* findings);
    void showWork(Analysis::State state);
    [[nodiscard]] QString stateText(Analysis::State state) const;
    [[nodiscard]] Analysis::State state() const;
    [[nodiscard]] std::shared_ptr<const MeshAnalysis> findings() const;
    [[nodiscard]] double fraction() const;

    Analysis* m_analysis;
    ShapeChecks* m_shapes = nullptr;
    NodeId m_node = noNode;
    bool m_isShape = false;
    QLabel* m_text;
    QLabel* m_shape;
    QLabel* m_hash;
    HistogramView* m_histogram;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QPushButton* m_again;
    QPushButton* m_separate;
};

} // namespace ramure
