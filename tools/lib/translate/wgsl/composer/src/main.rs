//! Composes shaders as Bevy does, by naga_oil, and writes each as WGSL without imports.
//!
//!     composer FOLDER [MODULE ...] -- [SHADER ...]
//!
//! SHADER becomes FOLDER/SHADER, by its file name. Exit status: 0 done, 1 naga_oil reports an error.

use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor, ShaderLanguage};
use std::path::Path;

fn composed(arguments: &[String]) -> Result<(), String> {
    let folder = Path::new(&arguments[0]);
    let middle = arguments.iter().position(|argument| argument == "--").ok_or("there is no --")?;
    let read = |path: &String| std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"));
    let mut composer = Composer::default();
    for path in &arguments[1..middle] {
        let source = read(path)?;
        let module = ComposableModuleDescriptor {
            source: &source,
            file_path: path,
            language: ShaderLanguage::Wgsl,
            ..Default::default()
        };
        let error = composer.add_composable_module(module).err();
        if let Some(error) = error {
            return Err(error.emit_to_string(&composer));
        }
    }
    for path in &arguments[middle + 1..] {
        let source = read(path)?;
        let shader = NagaModuleDescriptor { source: &source, file_path: path, ..Default::default() };
        let module = match composer.make_naga_module(shader) {
            Ok(module) => module,
            Err(error) => return Err(error.emit_to_string(&composer)),
        };
        let info = naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::all())
            .validate(&module)
            .map_err(|error| format!("{path}: {error:?}"))?;
        let flags = naga::back::wgsl::WriterFlags::empty();
        let text = naga::back::wgsl::write_string(&module, &info, flags).map_err(|error| format!("{path}: {error}"))?;
        let name = Path::new(path).file_name().ok_or("a shader has no name")?;
        std::fs::write(folder.join(name), text).map_err(|error| error.to_string())?;
    }
    Ok(())
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let Err(error) = composed(&arguments) {
        eprintln!("{error}");
        std::process::exit(1);
    }
}
