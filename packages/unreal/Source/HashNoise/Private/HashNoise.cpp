// Of hashnoise. Copyright (c) 2026 The hashnoise authors; MIT License.
#include "CoreMinimal.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "ShaderCore.h"

// Gives the engine the folder of the plugin's shaders, before it compiles any: so materials include
// "/HashNoise/HashNoise.ush".
class FHashNoiseModule : public IModuleInterface {
 public:
  virtual void StartupModule() override {
    const TSharedPtr<IPlugin> Plugin = IPluginManager::Get().FindPlugin(TEXT("HashNoise"));
    AddShaderSourceDirectoryMapping(TEXT("/HashNoise"), FPaths::Combine(Plugin->GetBaseDir(), TEXT("Shaders")));
  }
};

IMPLEMENT_MODULE(FHashNoiseModule, HashNoise)
