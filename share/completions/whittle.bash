# whittle.bash — completion of whittle's verbs, options and values for bash.
_whittle() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]} options
    case $previous in
        --progress) COMPREPLY=($(compgen -W "auto never json" -- "$current")); return ;;
        --diagnostics) COMPREPLY=($(compgen -W "text json" -- "$current")); return ;;
        --curves) COMPREPLY=($(compgen -W "auto exact faceted" -- "$current")); return ;;
        --projection) COMPREPLY=($(compgen -W "p o" -- "$current")); return ;;
        --sampler) COMPREPLY=($(compgen -W "sobol stratified independent" -- "$current")); return ;;
        --filter) COMPREPLY=($(compgen -W "box gaussian mitchell" -- "$current")); return ;;
        --colorscheme) COMPREPLY=($(compgen -W "Cornfield Metallic Sunset Starnight BeforeDawn Nature DeepOcean Solarized Tomorrow Monotone" -- "$current")); return ;;
        --tonemap) COMPREPLY=($(compgen -W "srgb filmic linear" -- "$current")); return ;;
        --exr) COMPREPLY=($(compgen -W "half float" -- "$current")); return ;;
        --integrator) COMPREPLY=($(compgen -W "auto preview whitted distributed path caustics cone" -- "$current")); return ;;
        --aov) COMPREPLY=($(compgen -W "depth position normal solid surface albedo spans thickness certified cost variance" -- "$current")); return ;;
        --check-parameters) COMPREPLY=($(compgen -W "true false" -- "$current")); return ;;
        --export-format) COMPREPLY=($(compgen -W "png exr jpg tif stl asciistl binstl 3mf off obj ply amf glb om svg dxf pdf pov csg echo ast param" -- "$current")); return ;;
        -o | -d | -p | --stats | --rays) COMPREPLY=($(compgen -f -- "$current")); return ;;
    esac
    case $verb in
        render)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable --imgsize --camera --viewall
                --autocenter --projection --samples --light-samples --noise --stop-after --max-depth --integrator --aov
                --edges --clip --xray --exposure --tonemap --exr --watch --tile --shard --colorscheme --photons --sampler --filter --resume -o" ;;
        mesh)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable --tolerance --angle --booleans --simplify --remesh --binary
                --ascii --report -o" ;;
        check)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable --tolerance --angle --booleans --lines --heat --suite" ;;
        measure)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable" ;;
        spans)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable --ray --rays" ;;
        merge)
            options="-h --help -v --version --threads --seed --progress --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable
                -o" ;;
        *)
            options="-h --help -v --version -D -p -P --curves --no-snap --hardwarnings --allow-missing -d --threads --seed --progress
                --diagnostics --json -q --quiet --stats --limit-time --limit-memory --disable --export-format --check-parameters
                --render --preview --animate --csglimit --check-parameter-ranges --backend --enable --debug -m -O -s -x --view --summary --summary-file --info --imgsize --camera --viewall --autocenter --projection --samples --light-samples
                --noise --stop-after --max-depth --integrator --aov --edges --clip --xray --exposure --tonemap --exr
                --watch --tile --shard --colorscheme --photons --sampler --filter --resume --tolerance --angle --booleans --simplify --remesh --binary --ascii --report -o" ;;
    esac
    if [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
        return
    fi
    [[ $COMP_CWORD -eq 1 ]] && COMPREPLY=($(compgen -W "render mesh check measure spans merge bench" -- "$current"))
    COMPREPLY+=($(compgen -f -X '!*.@(scad|csg|exr)' -- "$current") $(compgen -d -- "$current"))
}
shopt -s extglob
complete -o filenames -F _whittle whittle
