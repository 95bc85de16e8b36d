//! Links shaders by the crate wesl: `linker FOLDER` writes FOLDER/NAME.wgsl of each FOLDER/NAME.wesl.
//!
//! Exit status: 0 done, 1 wesl reports an error.

use wesl::{resolver::StandardResolver, Compiler};

fn linked(folder: &str) -> Result<(), String> {
    for file in std::fs::read_dir(folder).map_err(|error| error.to_string())? {
        let path = file.map_err(|error| error.to_string())?.path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".wesl")) else { continue };
        let mut resolver = StandardResolver::new(folder);
        resolver.add_package(&hashnoise_wgsl::PACKAGE);
        let module = format!("package::{name}").parse().map_err(|_| format!("{name} is no name of a module"))?;
        let made = Compiler::default().with_resolver(resolver).compile_module(&module).map_err(|error| error.to_string())?;
        std::fs::write(path.with_extension("wgsl"), made.syntax.to_string()).map_err(|error| error.to_string())?;
    }
    Ok(())
}

fn main() {
    let folder = std::env::args().nth(1).unwrap_or_default();
    if let Err(error) = linked(&folder) {
        eprintln!("{error}");
        std::process::exit(1);
    }
}
