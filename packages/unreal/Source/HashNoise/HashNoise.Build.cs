// Of hashnoise. Copyright (c) 2026 The hashnoise authors; MIT License.
using UnrealBuildTool;

public class HashNoise : ModuleRules
{
    public HashNoise(ReadOnlyTargetRules Target) : base(Target)
    {
        PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
        PrivateDependencyModuleNames.AddRange(new string[] { "Core", "Projects", "RenderCore" });
    }
}
