#if UNITY_EDITOR
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

/// Makes one prefab with a LODGroup and colliders of the levels NAME_LOD0, NAME_LOD1 ... of a folder.
public static class RamureTree
{
    // Shares of the screen's height down to which each level is shown, and the last one's end.
    static readonly float[] shares = { @UNITY_SHARES@ };

    [MenuItem("Assets/Ramure/Make a tree of this folder")]
    static void Make()
    {
        string folder = AssetDatabase.GetAssetPath(Selection.activeObject);
        if (!AssetDatabase.IsValidFolder(folder))
            folder = Path.GetDirectoryName(folder);
        string name = Path.GetFileName(folder);
        var levels = AssetDatabase.FindAssets("_LOD t:GameObject", new[] { folder })
            .Select(AssetDatabase.GUIDToAssetPath).Where(path => path.EndsWith(".glb")).OrderBy(path => path).ToArray();
        var root = new GameObject(name);
        var lods = new LOD[levels.Length];
        for (int i = 0; i < levels.Length; i++)
        {
            var level = (GameObject)PrefabUtility.InstantiatePrefab(AssetDatabase.LoadAssetAtPath<GameObject>(levels[i]));
            level.transform.SetParent(root.transform, false);
            foreach (var filter in level.GetComponentsInChildren<MeshFilter>().Where(one => one.name.StartsWith("COL_")))
            {
                var collider = filter.gameObject.AddComponent<MeshCollider>();
                collider.sharedMesh = filter.sharedMesh;
                collider.convex = true;
                filter.GetComponent<MeshRenderer>().enabled = false;
            }
            var seen = level.GetComponentsInChildren<Renderer>().Where(one => !one.name.StartsWith("COL_")).ToArray();
            lods[i] = new LOD(shares[Mathf.Min(i, shares.Length - 1)], seen);
        }
        root.AddComponent<LODGroup>().SetLODs(lods);
        PrefabUtility.SaveAsPrefabAsset(root, folder + "/" + name + ".prefab");
        Object.DestroyImmediate(root);
    }
}
#endif
