/// \file
/// A document with trees that are computed on the spot: what panels show is there without waiting for a
/// thread.
#pragma once

#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/document.h"
#include <QTranslator>

namespace ramure::test {

class TreeDocument
{
public:
    [[nodiscard]] Document& document() { return m_document; }

    /// Adds a tree with its result; noNode where its parameters give none.
    NodeId add(const NodeParams& params, const std::string& name = "Tree")
    {
        Node node;
        node.id = 1;
        node.kind = NodeKind::Tree;
        node.name = name;
        node.params = params;
        const auto id = edit::insertNodes(m_document, {node}, noNode, 0);
        if (!id || !compute(*id))
            return noNode;
        return *id;
    }
    NodeId addGroup()
    {
        Node node;
        node.id = 1;
        node.name = "Group";
        return edit::insertNodes(m_document, {node}, noNode, 0).value_or(noNode);
    }
    /// The result of the node's present parameters; with \p sections sections per branch where that is given.
    bool compute(NodeId id, int sections = 0)
    {
        NodeParams params = m_document.scene().find(id)->params;
        if (sections > 0)
            params.sections.lengthDivisions = sections;
        auto tree = m_pipeline.evaluate(params);
        NodeResult result;
        result.draft = sections > 0;
        result.revision = m_document.revision();
        if (!tree) {
            result.error = tree.error();
        } else {
            result.tree = *tree;
        }
        m_document.setResult(id, std::move(result));
        return tree.has_value();
    }
    [[nodiscard]] const Skeleton& skeleton(NodeId id)
    {
        return m_document.result(id)->tree.simplified->skeleton;
    }
    void select(NodeId id, std::vector<Index> branches, Index active)
    {
        Selection selection;
        selection.nodes = {id};
        selection.branchNode = id;
        selection.branches = std::move(branches);
        selection.activeBranch = active;
        m_document.setSelection(std::move(selection));
    }
    void selectNode(NodeId id)
    {
        Selection selection;
        selection.nodes = {id};
        m_document.setSelection(std::move(selection));
    }

private:
    Document m_document;
    TreePipeline m_pipeline;
};

/// A tree of a trunk with a fork of three, each with a fork of three: 13 branches, no leaves.
inline NodeParams smallForks()
{
    NodeParams params;
    params.grammar.axiom = "F[+F[+F][-F][^F]][-F[+F][-F][^F]]_F[+F][-F][^F]";
    params.grammar.rules = "";
    params.grammar.iterations = 0;
    params.foliage.leavesCutoff = 0.0;
    params.turtle.theta = 0.6;
    return params;
}

/// A language in which every text begins with a star and is half as long again, as German and French are.
class StarLanguage : public QTranslator
{
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char*, const char* source, const char*, int n) const override
    {
        const QString text = QString::fromUtf8(source).replace(QLatin1String("%n"), QString::number(n));
        QString tail;
        while (2 * tail.size() < text.size())
            tail += QStringLiteral(" mot");
        return u'★' + text + tail;
    }
};

/// While it lives, what is made speaks the language of stars.
class InStars
{
public:
    InStars() { QCoreApplication::installTranslator(&m_language); }
    ~InStars() { QCoreApplication::removeTranslator(&m_language); }
    InStars(const InStars&) = delete;
    InStars& operator=(const InStars&) = delete;

private:
    StarLanguage m_language;
};

} // namespace ramure::test
