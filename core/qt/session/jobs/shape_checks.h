/// \file
/// Checks the mesh of one arm, terrain, primitive or imported mesh of a document in the background: the one
/// that is looked at. Trees have their reports with their results, and Analysis.
#pragma once

#include "core/qt/session/jobs/analysis.h"
#include "core/scene/shape_check.h"
#include <QObject>
#include <functional>
#include <memory>

namespace ramure {

/// Keeps findings about each node's shape. After the shape has changed and rested a little, the check runs
/// again, and the old findings stay until it ends. The findings are no part of the document.
class ShapeChecks : public QObject
{
    Q_OBJECT
public:
    using State = Analysis::State;
    using Function = std::function<Expected<ShapeCheck>(const Node& node, const Progress& progress)>;
    struct Outcome
    {
        NodeResult result; ///< its tree holds the report and a copy of the mesh without branches
        std::shared_ptr<const MeshAnalysis> analysis;
        bool isOpen = false;
    };

    /// Arms as they rest, at 0 s. \param document must outlive this object.
    explicit ShapeChecks(Document* document, QObject* parent = nullptr);
    ShapeChecks(Document* document, Function function, QObject* parent = nullptr); ///< for tests
    ~ShapeChecks() override; ///< stops what runs and joins the thread

    /// Which node is looked at; noNode or no shape: none. Returns at once.
    void lookAt(NodeId node);
    [[nodiscard]] NodeId node() const;
    [[nodiscard]] State state() const;
    /// Null until the first check has ended. The result has an error if there is no mesh to check.
    [[nodiscard]] std::shared_ptr<const Outcome> outcome() const;
    [[nodiscard]] double fraction() const; ///< progress of the running check, 0..1
    /// How long a change rests before it is looked at, default 150 ms.
    void setRest(int milliseconds);

public slots:
    void cancel();
    void start(); ///< after a cancel, and for those who do not want to wait for the rest

signals:
    void changed(ramure::NodeId node); ///< state or outcome
    void progress(ramure::NodeId node, double fraction);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace ramure
